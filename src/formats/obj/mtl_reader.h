// The text of an MTL file as lists of what its materials say.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/math.h"
#include "formats/input/text_cursor.h"

namespace umbral {

// A texture, as 'map_Kd -s 2 2 1 file.png'.
struct MtlMap {
  std::string file;
  Place place;  // of the file's name
  Vec2 scale{1, 1}, offset{0, 0};
  bool clamp = false;
  bool blend_u = true, blend_v = true;
  float bump = 1;                    // multiplies heights
  float base = 0, gain = 1;          // value = base + gain × texel
  char channel = 0;                  // of -imfchan: r g b m l z; 0 where it is not given
  std::string color_space;           // "srgb", "linear" or empty
  std::vector<std::string> ignored;  // options without effect here
};

struct MtlMaterial {
  std::string name;
  Place place;
  std::map<std::string, Vec3> colors;    // Ka Kd Ks Ke Tf, where given; finite
  std::map<std::string, float> numbers;  // Ns Ni d Tr Pr Pm Ps Pc Pcr aniso anisor, where given; finite
  int illum = -1;                        // −1 where it is not given
  std::map<std::string, MtlMap>
      maps;  // map_Kd map_Ks map_Ns map_Ke map_d map_Pr map_Pm map_Ps norm bump, likewise
  std::vector<std::string> ignored;  // other statements, each once

  Vec3 color(const char* key, const Vec3& otherwise) const {
    const auto found = colors.find(key);
    return found == colors.end() ? otherwise : found->second;
  }
  std::optional<float> number(const char* key) const {
    const auto found = numbers.find(key);
    return found == numbers.end() ? std::nullopt : std::optional(found->second);
  }
  const MtlMap* map(const char* key) const {
    const auto found = maps.find(key);
    return found == maps.end() ? nullptr : &found->second;
  }
};

std::vector<MtlMaterial> parse_mtl(std::string_view text, TextErrors& errors);

}  // namespace umbral
