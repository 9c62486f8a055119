// RGB, tabulated spectra and materials by name.
#include "formats/mitsuba/colors.h"

#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "core/names.h"
#include "formats/translation/spectral_colors.h"

namespace umbral::mitsuba_file {
namespace {

std::string value_of(const Element& element) {
  const auto found = element.attributes.find("value");
  return found == element.attributes.end() ? std::string() : found->second;
}

// "#18455c" is encoded as sRGB.
std::optional<Spectrum> hexadecimal(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned number = 0;
  const auto [end, failure] = std::from_chars(text.data() + 1, text.data() + 7, number, 16);
  if (failure != std::errc() || end != text.data() + 7) return std::nullopt;
  const auto channel = [&](int shift) {
    return srgb_decode(static_cast<float>((number >> shift) & 255) / 255);
  };
  return rgb(channel(16), channel(8), channel(0));
}

std::optional<Spectrum> rgb_in(const std::string& text) {
  if (const auto color = hexadecimal(text)) return color;
  const std::vector<double> v = numbers_in(text);
  if (v.size() == 1) return grey(static_cast<float>(v[0]));
  if (v.size() != 3) return std::nullopt;
  return rgb(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
}

// "400:0.1, 500:0.2", interpolated, and 0 beyond its ends.
std::optional<SpectralCurve> table_in(std::string text) {
  for (char& c : text)
    if (c == ':') c = ' ';
  const std::vector<double> v = numbers_in(text);
  if (v.size() < 4 || v.size() % 2 != 0) return std::nullopt;
  for (std::size_t i = 2; i < v.size(); i += 2)
    if (!(v[i] > v[i - 2])) return std::nullopt;
  return [v](double nanometres) {
    if (nanometres < v.front() || nanometres > v[v.size() - 2]) return 0.0;
    std::size_t i = 2;
    while (i + 2 < v.size() && nanometres > v[i]) i += 2;
    const double t = (nanometres - v[i - 2]) / (v[i] - v[i - 2]);
    return v[i - 1] + t * (v[i + 1] - v[i - 1]);
  };
}

enum class Use { surface, light, unbounded };

std::optional<Spectrum> color_in(const Element& element, Use use) {
  const std::string text = value_of(element);
  if (element.tag == "rgb" || element.tag == "srgb" || element.tag == "float") return rgb_in(text);
  const std::vector<double> single = numbers_in(text);
  if (single.size() == 1 && use != Use::light) return grey(static_cast<float>(single[0]));
  if (single.size() == 1) return emission_color([&](double) { return single[0]; });
  if (single.size() == 3) return rgb_in(text);  // as Mitsuba 0.x wrote colours
  const auto table = table_in(text);
  if (!table) return std::nullopt;
  return use == Use::light ? emission_color(*table) : reflectance_color(*table);
}

Spectrum checked_color(SceneBuilder& builder, const Element& element, Use use) {
  if (!is_color(element) || element.attributes.contains("filename")) {
    builder.lacks(element.place, fmt::format("'{}' by <{}{}>", element.name, element.tag,
                                             element.type.empty() ? "" : " type=" + element.type));
    return grey(0.5f);
  }
  const std::optional<Spectrum> color = color_in(element, use);
  if (color && min_component(*color) >= 0 && is_finite(*color)) return *color;
  builder.diagnostics.error(element.place,
                            fmt::format("'{}' is no colour: '{}'", element.name, value_of(element)));
  return grey(0.5f);
}

// Indices of refraction at 589 nm, from handbooks, by the names that Mitsuba has for them.
constexpr std::array<std::pair<const char*, double>, 25> indices{
    {{"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
     {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.3330},
     {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
     {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
     {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
     {"pyrex", 1.470},     {"acrylic glass", 1.49},     {"polypropylene", 1.49},
     {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
     {"pet", 1.5750},      {"diamond", 2.419},          {"glass", 1.5},
     {"plastic", 1.46}}};

double index_of_refraction(SceneBuilder& builder, const Properties& properties, const char* name,
                           const std::string& usual) {
  const Element* found = properties.find(name);
  if (found && found->tag != "string") return properties.number(name, 1.5);
  const std::string material = found ? properties.text(name, usual) : usual;
  std::vector<std::string> names;
  for (const auto& [known, index] : indices) {
    if (material == known) return index;
    names.emplace_back(known);
  }
  builder.diagnostics.error(
      found->place, fmt::format("no index is known of '{}'{}", material, suggestion(material, names)));
  return 1.5;
}

}  // namespace

bool is_color(const Element& element) {
  return element.tag == "rgb" || element.tag == "srgb" || element.tag == "spectrum" || element.tag == "float";
}

Spectrum surface_color(SceneBuilder& builder, const Element& element) {
  const Spectrum color = checked_color(builder, element, Use::surface);
  const Spectrum kept = glm::min(color, Spectrum(1.0f));
  if (kept != color)
    builder.diagnostics.warning(element.place, fmt::format("'{}' is cut to the range 0 … 1", element.name));
  return kept;
}

Spectrum light_color(SceneBuilder& builder, const Element& element) {
  return checked_color(builder, element, Use::light);
}

Spectrum light_color(SceneBuilder& builder, const Properties& properties, const std::string& name,
                     const Spectrum& otherwise) {
  const Element* found = properties.find(name);
  return found ? light_color(builder, *found) : otherwise;
}

Spectrum unbounded_color(SceneBuilder& builder, const Element& element) {
  return checked_color(builder, element, Use::unbounded);
}

float relative_index(SceneBuilder& builder, const Properties& properties, const char* usual_inside) {
  const double inside = index_of_refraction(builder, properties, "int_ior", usual_inside),
               outside = index_of_refraction(builder, properties, "ext_ior", "air");
  const double index = inside / outside;
  if (index >= 1 && index <= 10) return static_cast<float>(index);
  builder.lacks(properties.place(),
                fmt::format("a relative index of refraction of {:.4g}; it must be 1 … 10", index));
  return 1.5f;
}

}  // namespace umbral::mitsuba_file
