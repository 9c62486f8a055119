// TexturePoint: all that the value of a texture may depend on, at one point of a surface.
#pragma once

#include "core/math.h"
#include "core/spectrum.h"

namespace umbral {

// `uv` is always there. Of the rest a surface fills in what the textures of its material ask for (TextureNeeds).
struct TexturePoint {
  Vec2 uv{0, 0};
  Vec2 uv1{0, 0};              // the second set; where the mesh has none, the first
  Vec3 p{0, 0, 0};             // of the object, before an instance moves it; of the world where there is none
  float footprint = 0;         // width in uv of what a look-up stands for; 0 is a point
  float footprint1 = 0;        // likewise, in uv1
  std::uint32_t random = 0;    // chooses among texels; 0 chooses none: they are interpolated
  Spectrum color{1, 1, 1, 1};  // of the vertices, with alpha; white where the mesh has none

  TexturePoint() = default;
  TexturePoint(const Vec2& uv_) : uv(uv_) {}  // NOLINT(google-explicit-constructor): uv alone often will do
  TexturePoint(float u, float v) : uv(u, v) {}

  float footprint_of(int set) const { return set == 0 ? footprint : footprint1; }
  const Vec2& uv_of(int set) const { return set == 0 ? uv : uv1; }
};

// What a texture asks of a TexturePoint beside uv; to be joined with |.
namespace texture_needs {
inline constexpr unsigned uv1 = 1, position = 2, color = 4, footprint = 8, random = 16;
}

// How far apart two points of a texture may be and still tell its slope; infinite where it does not change with them.
struct TextureStep {
  float uv = infinity;        // of either set
  float position = infinity;  // of the object's space
  float color = infinity;

  TextureStep finer(const TextureStep& other) const {
    return {std::min(uv, other.uv), std::min(position, other.position), std::min(color, other.color)};
  }
};

}  // namespace umbral
