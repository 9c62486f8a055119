// How an image covers all directions.
#pragma once

#include <array>

#include "core/parameters.h"
#include "image/texture_image.h"

namespace umbral {

// Directions are in the frame of the image, unit, +y up. Positions are in the unit square as those of TextureImage, v up.
//
// `equirectangular`: the middle column is −z, columns to its right are further right, the top row is +y.
// `equal_area`: octahedral, each texel with the same solid angle [Clarberg 2008]: +y in the middle, −y in the corners, the
// horizon on the square through the middles of the edges. This is the mapping of pbrt-v4, and looks the same as the
// equirectangular image that its `imgtool makeequiarea` is given.
enum class SphereMapping { equirectangular, equal_area };

template <>
struct EnumNames<SphereMapping> {
  static constexpr std::array names{"equirectangular", "equal_area"};
};

Vec2 square_of(SphereMapping mapping, const Vec3& direction);
Vec3 direction_of(SphereMapping mapping, const Vec2& square);
// dω/dA, solid angle by area of the square.
float stretch_at(SphereMapping mapping, const Vec3& direction);

// Takes a direction in the axes of pbrt-v4's equal-area images (and of Clarberg's paper; +z in the middle, +x towards the
// right edge of the picture, +y towards its bottom edge) to the frame of the image.
inline constexpr Mat3 frame_of_equal_area{{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}};

// A position that may be up to an edge's length outside of the square, brought back as the sphere closes.
Vec2 folded(SphereMapping mapping, const Vec2& square);

// The four texels around a position, those beyond the edges as the sphere closes: (x₀, y₀), (x₁, y₀), (x₀, y₁), (x₁, y₁).
struct TexelCorners {
  std::array<glm::ivec2, 4> texels;
  Vec2 fraction;  // from the first to the last

  template <class Value>  // of a texel: value(x, y)
  auto mean(const Value& value) const {
    const auto at = [&](std::size_t i) { return value(texels[i].x, texels[i].y); };
    const auto a = at(0), b = at(1), c = at(2), d = at(3);
    const auto low = a + fraction.x * (b - a), high = c + fraction.x * (d - c);
    return low + fraction.y * (high - low);
  }
};
TexelCorners corners_at(SphereMapping mapping, const Vec2& square, int width, int height);

// The image seen along `direction`, bilinear.
Spectrum seen_along(const TextureImage& image, SphereMapping mapping, const Vec3& direction);

}  // namespace umbral
