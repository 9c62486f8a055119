// Statement after statement of an MTL file.
#include "formats/obj/mtl_reader.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace umbral {
namespace {

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<const char*, N>& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

class MtlParser {
 public:
  MtlParser(std::string_view text, TextErrors& errors) : in_(text), errors_(errors) {}

  std::vector<MtlMaterial> parse();

 private:
  void statement();
  void begin_material();
  void read_color(MtlMaterial& material, const std::string& key);
  bool read_number(float& number);
  void read_map(MtlMaterial& material, const std::string& key);
  bool read_option(const std::string& key, MtlMap& map);
  bool read_pair(Vec2& pair);
  Place here() { return errors_.place(in_, in_.position()); }

  TextCursor in_;
  TextErrors& errors_;
  std::vector<MtlMaterial> materials_;
};

void MtlParser::begin_material() {
  in_.at_line_end();
  MtlMaterial material;
  material.place = here();
  material.name = in_.rest_of_line();
  const bool known = std::any_of(materials_.begin(), materials_.end(),
                                 [&](const MtlMaterial& other) { return other.name == material.name; });
  if (known)
    errors_.warning(material.place,
                    fmt::format("there is a material '{}' already; this one is not used", material.name));
  materials_.push_back(std::move(material));
}

bool MtlParser::read_number(float& number) {
  const bool missing = in_.at_line_end();
  const Place place = here();
  double value = 0;
  const bool good = in_.number(value) && std::isfinite(static_cast<float>(value));
  if (good)
    number = static_cast<float>(value);
  else
    errors_.error(place, missing ? "a number is missing here" : "this is not a finite number");
  return good;
}

// One number for grey or three; the forms 'spectral' and 'xyz' are told as unused.
void MtlParser::read_color(MtlMaterial& material, const std::string& key) {
  if (!in_.at_line_end() && (*in_.position() == 's' || *in_.position() == 'x')) {
    material.ignored.push_back(key + " " + std::string(in_.word()));
    return;
  }
  Vec3 color{0};
  if (!read_number(color.r)) return;
  color = Vec3(color.r);
  if (!in_.at_line_end() && !(read_number(color.g) && read_number(color.b))) return;
  material.colors[key] = color;
}

// Up to three numbers, of which the third belongs to volumes.
bool MtlParser::read_pair(Vec2& pair) {
  double value = 0;
  if (!read_number(pair.x)) return false;
  if (in_.number(value)) pair.y = static_cast<float>(value);
  in_.number(value);
  return is_finite(pair);
}

bool MtlParser::read_option(const std::string& key, MtlMap& map) {
  static constexpr std::array harmless{"-texres", "-cc", "-boost"};
  const std::string option(in_.word());
  if (option == "-s") return read_pair(map.scale);
  if (option == "-o") return read_pair(map.offset);
  if (option == "-mm") return read_number(map.base) && read_number(map.gain);
  if (option == "-clamp") {
    map.clamp = in_.word() == "on";
  } else if (option == "-blendu") {
    map.blend_u = in_.word() != "off";
  } else if (option == "-blendv") {
    map.blend_v = in_.word() != "off";
  } else if (option == "-bm" && key == "bump") {
    return read_number(map.bump);
  } else if (option == "-imfchan") {
    const std::string_view channel = in_.word();
    map.channel = channel.empty() ? '\0' : channel[0];
  } else if (option == "-colorspace") {
    map.color_space = in_.word();
    std::transform(map.color_space.begin(), map.color_space.end(), map.color_space.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  } else if (option == "-t") {
    Vec2 turbulence{0};
    map.ignored.push_back(option);
    return read_pair(turbulence);
  } else {
    in_.word();
    if (!is_one_of(option, harmless)) map.ignored.push_back(option);
  }
  return true;
}

void MtlParser::read_map(MtlMaterial& material, const std::string& key) {
  MtlMap map;
  while (!in_.at_line_end() && *in_.position() == '-')
    if (!read_option(key, map)) return;
  map.place = here();
  map.file = in_.rest_of_line();
  if (map.file.empty())
    errors_.error(map.place, fmt::format("the file of '{}' is missing", key));
  else
    material.maps[key] = std::move(map);
}

void MtlParser::statement() {
  static constexpr std::array colors{"Ka", "Kd", "Ks", "Ke", "Tf"};
  static constexpr std::array numbers{"Ns", "Ni", "d",   "Tr",    "Pr",    "Pm",
                                      "Ps", "Pc", "Pcr", "aniso", "anisor"};
  static constexpr std::array maps{"map_Kd", "map_Ks", "map_Ns", "map_Ke", "map_d",
                                   "map_Pr", "map_Pm", "map_Ps", "norm",   "bump"};
  static constexpr std::array bumps{"map_bump", "map_Bump"};
  const Place place = here();
  const std::string word(in_.word());
  if (word == "newmtl") return begin_material();
  if (materials_.empty()) {
    errors_.error(place, fmt::format("'{}' comes before any 'newmtl'", word.substr(0, 40)));
    return;
  }
  MtlMaterial& material = materials_.back();
  if (is_one_of(word, colors)) {
    read_color(material, word);
  } else if (is_one_of(word, numbers)) {
    if (word == "d" && !in_.at_line_end() && *in_.position() == '-')
      material.ignored.push_back("d -halo"), in_.word();
    float number = 0;
    if (read_number(number)) material.numbers[word] = number;
  } else if (is_one_of(word, maps)) {
    read_map(material, word);
  } else if (is_one_of(word, bumps)) {
    read_map(material, "bump");
  } else if (word == "illum") {
    float number = 0;
    if (read_number(number)) material.illum = static_cast<int>(std::clamp(number, -1.0f, 100.0f));
  } else if (std::find(material.ignored.begin(), material.ignored.end(), word) == material.ignored.end()) {
    material.ignored.push_back(word.substr(0, 40));
  }
}

std::vector<MtlMaterial> MtlParser::parse() {
  while (!in_.at_end() && !errors_.full()) {
    if (!in_.at_line_end()) statement();
    in_.next_line();
  }
  return std::move(materials_);
}

}  // namespace

std::vector<MtlMaterial> parse_mtl(std::string_view text, TextErrors& errors) {
  return MtlParser(text, errors).parse();
}

}  // namespace umbral
