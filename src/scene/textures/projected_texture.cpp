// Projections of points to uv.
#include "scene/textures/projected_texture.h"

namespace umbral {
namespace {

// φ/2π, in [0, 1).
float turn_about_y(const Vec3& q) {
  const float turn = std::atan2(q.x, q.z) / two_pi;
  return turn < 0 ? std::min(turn + 1, one_minus_epsilon) : turn;
}

Vec2 projected(Projection projection, const Vec3& q) {
  if (projection == Projection::planar) return {q.x, q.y};
  if (projection == Projection::cylindrical) return {turn_about_y(q), q.y};
  return {turn_about_y(q), 1 - std::atan2(std::sqrt(q.x * q.x + q.z * q.z), q.y) * inverse_pi};
}

}  // namespace

TexturePoint ProjectedTexture::laid(const TexturePoint& point) const {
  const Vec3 way = point.p - origin;
  TexturePoint result = point;
  result.uv = result.uv1 = projected(projection, {dot(way, x), dot(way, y), dot(way, z)});
  result.footprint = result.footprint1 = 0;
  return result;
}

unsigned ProjectedTexture::needs() const {
  constexpr unsigned replaced = texture_needs::uv1 | texture_needs::footprint;
  return texture_needs::position | (texture_input.needs() & ~replaced);
}

// Round ones: of a point 1/π or more from the axis in q, around which uv changes no faster than q does.
TextureStep ProjectedTexture::step() const {
  const TextureStep inner = texture_input.step();
  const float longest = std::max({glm::length(x), glm::length(y), glm::length(z), 1e-30f});
  return {infinity, std::min(inner.position, inner.uv / longest), inner.color};
}

}  // namespace umbral
