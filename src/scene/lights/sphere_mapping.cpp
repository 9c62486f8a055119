// The two mappings, their inverses, and how their edges join.
#include "scene/lights/sphere_mapping.h"

namespace umbral {
namespace {

// Of the angle between a unit vector and the y axis.
float sine_of(const Vec3& d) { return std::sqrt(d.x * d.x + d.z * d.z); }

Vec2 equirectangular_square(const Vec3& d) {
  const float azimuth = std::atan2(d.x, -d.z) / two_pi + 0.5f;
  // By the arc tangent: near the poles the cosine alone has lost the angle.
  return {std::min(azimuth, one_minus_epsilon), 1 - std::atan2(sine_of(d), d.y) * inverse_pi};
}

Vec3 equirectangular_direction(const Vec2& square) {
  const float theta = pi * (1 - square.y), phi = two_pi * (square.x - 0.5f), sine = std::sin(theta);
  return {sine * std::sin(phi), std::cos(theta), -sine * std::cos(phi)};
}

// In the axes of [Clarberg 2008]: r = √(1 − |z|) and φ in a quadrant become r − v and v = r 2φ/π; below the horizon the
// triangle is turned over its diagonal.
Vec2 equal_area_square(const Vec3& direction) {
  const Vec3 d = transpose(frame_of_equal_area) * direction;
  const float r = std::sqrt((d.x * d.x + d.y * d.y) / (1 + std::abs(d.z)));
  const float v = r * std::atan2(std::abs(d.y), std::abs(d.x)) * (2 * inverse_pi), u = r - v;
  const Vec2 octant = d.z < 0 ? Vec2(1 - v, 1 - u) : Vec2(u, v);
  // Rows of a picture go down, v goes up.
  return {(1 + std::copysign(octant.x, d.x)) / 2, (1 - std::copysign(octant.y, d.y)) / 2};
}

Vec3 equal_area_direction(const Vec2& square) {
  const Vec2 p(2 * square.x - 1, 1 - 2 * square.y);
  const Vec2 octant = glm::abs(p);
  const float inside = 1 - octant.x - octant.y;  // negative below the horizon
  const float r = 1 - std::abs(inside);
  const float phi = r > 0 ? ((octant.y - octant.x) / r + 1) * pi / 4 : 0.0f;
  const float sine = r * safe_sqrt(2 - r * r);
  return frame_of_equal_area * Vec3{std::copysign(sine * std::cos(phi), p.x),
                                    std::copysign(sine * std::sin(phi), p.y),
                                    std::copysign(1 - r * r, inside)};
}

// Beyond an edge of the octahedral square it goes on from that same edge, turned round the edge's middle.
glm::ivec2 folded_texel(SphereMapping mapping, glm::ivec2 p, int width, int height) {
  if (mapping == SphereMapping::equirectangular)
    return {(p.x + width) % width, std::clamp(p.y, 0, height - 1)};
  for (int axis = 0; axis < 2; ++axis) {
    const int size = axis == 0 ? width : height, other = axis == 0 ? height : width;
    if (p[axis] >= 0 && p[axis] < size) continue;
    p[axis] = p[axis] < 0 ? -1 - p[axis] : 2 * size - 1 - p[axis];
    p[1 - axis] = other - 1 - p[1 - axis];
  }
  return p;
}

}  // namespace

Vec2 square_of(SphereMapping mapping, const Vec3& direction) {
  return mapping == SphereMapping::equirectangular ? equirectangular_square(direction)
                                                   : equal_area_square(direction);
}

Vec3 direction_of(SphereMapping mapping, const Vec2& square) {
  return mapping == SphereMapping::equirectangular ? equirectangular_direction(square)
                                                   : equal_area_direction(square);
}

float stretch_at(SphereMapping mapping, const Vec3& direction) {
  return mapping == SphereMapping::equirectangular ? 2 * pi * pi * sine_of(direction) : 4 * pi;
}

Vec2 folded(SphereMapping mapping, const Vec2& square) {
  if (mapping == SphereMapping::equirectangular) {
    // It repeats around the horizon, and is reflected at the poles, as its look-up stays at the last row there.
    const float y = std::abs(square.y);
    return {square.x - std::floor(square.x), y > 1 ? 2 - y : y};
  }
  Vec2 p = square;
  for (int axis = 0; axis < 2; ++axis) {
    if (p[axis] >= 0 && p[axis] <= 1) continue;
    p[axis] = p[axis] < 0 ? -p[axis] : 2 - p[axis];
    p[1 - axis] = 1 - p[1 - axis];
  }
  return p;
}

TexelCorners corners_at(SphereMapping mapping, const Vec2& square, int width, int height) {
  const Vec2 at = square * Vec2(width, height) - 0.5f;
  const Vec2 low = glm::floor(at);
  const glm::ivec2 first(low);
  TexelCorners corners{{}, at - low};
  for (int i = 0; i < 4; ++i)
    corners.texels[static_cast<std::size_t>(i)] =
        folded_texel(mapping, first + glm::ivec2(i & 1, i >> 1), width, height);
  return corners;
}

Spectrum seen_along(const TextureImage& image, SphereMapping mapping, const Vec3& direction) {
  return corners_at(mapping, square_of(mapping, direction), image.width(), image.height())
      .mean([&](int x, int y) { return image.texel(x, y); });
}

}  // namespace umbral
