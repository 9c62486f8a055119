// Lattices of random gradients and of random points.
#include "core/noise.h"

#include "core/hash.h"

namespace umbral {
namespace {

struct Cell {
  std::int32_t x, y, z;
};

bool is_near(const Vec3& p) { return std::abs(p.x) < 1e9f && std::abs(p.y) < 1e9f && std::abs(p.z) < 1e9f; }

Cell cell_of(const Vec3& p) {
  return {static_cast<std::int32_t>(std::floor(p.x)), static_cast<std::int32_t>(std::floor(p.y)),
          static_cast<std::int32_t>(std::floor(p.z))};
}

std::uint64_t hash_of(const Cell& c) {
  const std::uint64_t xy =
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.x)) << 32 | static_cast<std::uint32_t>(c.y);
  return hash_combine(xy, static_cast<std::uint32_t>(c.z));
}

// d · g for one of twelve gradients g, the middles of a cube's edges.
float slope(const Cell& c, const Vec3& d) {
  const auto h = static_cast<std::uint32_t>(hash_of(c) >> 32) & 15;
  const float u = h < 8 ? d.x : d.y;
  const float v = h < 4 ? d.y : (h == 12 || h == 14) ? d.x : d.z;
  return ((h & 1) != 0 ? -u : u) + ((h & 2) != 0 ? -v : v);
}

// 6t⁵ − 15t⁴ + 10t³: level in value, slope and curvature at both ends.
float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

float gradient_noise(const Vec3& p) {
  if (!is_near(p)) return 0;
  const Cell c = cell_of(p);
  const Vec3 f = p - glm::floor(p);
  const auto corner = [&](int x, int y, int z) {
    return slope({c.x + x, c.y + y, c.z + z}, f - Vec3(x, y, z));
  };
  const float u = fade(f.x), v = fade(f.y), w = fade(f.z);
  const auto edge = [&](int y, int z) { return glm::mix(corner(0, y, z), corner(1, y, z), u); };
  const auto side = [&](int z) { return glm::mix(edge(0, z), edge(1, z), v); };
  return glm::clamp(glm::mix(side(0), side(1), w), -1.0f, 1.0f);
}

float fractal_noise(const Vec3& p, int octaves, float gain) {
  float sum = 0, most = 0, height = 1, frequency = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += height * gradient_noise(p * frequency);
    most += height;
    height *= gain;
    frequency *= 2;
  }
  return sum / most;
}

// Points two cubes away may be the second nearest. Cubes are looked at from the middle outwards, and not those that are
// further away than what was found.
NearestPoints nearest_points(const Vec3& p) {
  if (!is_near(p)) return {0, 0, 0};
  const Cell c = cell_of(p);
  const Vec3 f = p - glm::floor(p);
  NearestPoints nearest{infinity, infinity, 0};
  constexpr int order[] = {0, -1, 1, -2, 2};
  const auto look_at = [&](int x, int y, int z) {
    const Vec3 corner = Vec3(x, y, z) - f;  // from p
    const Vec3 gap = glm::max(glm::max(corner, -1.0f - corner), 0.0f);
    if (dot(gap, gap) >= sqr(nearest.second)) return;
    const std::uint64_t hash = hash_of({c.x + x, c.y + y, c.z + z});
    const auto number = [&](int shift) { return unit_float(static_cast<std::uint32_t>(hash >> shift)); };
    const float distance = glm::length(corner + Vec3(number(0), number(32), number(16)));
    if (distance < nearest.first)
      nearest = {distance, nearest.first, number(24)};
    else
      nearest.second = std::min(nearest.second, distance);
  };
  for (const int z : order)
    for (const int y : order)
      for (const int x : order) look_at(x, y, z);
  return nearest;
}

}  // namespace umbral
