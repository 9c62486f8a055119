// Weights of texels, and the tents around them.
#include "scene/lights/sphere_distribution.h"

namespace umbral {
namespace {

// By the density 1 − |x| in (−1, 1).
float tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 * (1 - u)); }

}  // namespace

SphereDistribution::SphereDistribution(const TextureImage& image, SphereMapping mapping)
    : mapping_(mapping), width_(image.width()), height_(image.height()) {
  std::vector<double> weights;
  weights.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  double areas = 0;
  for (int y = 0; y < height_; ++y) {
    const double area = mapping == SphereMapping::equal_area ? 1 : std::sin(pi_d * (y + 0.5) / height_);
    areas += area * width_;
    for (int x = 0; x < width_; ++x) weights.push_back(luminance(image.texel(x, y)) * area);
  }
  texels_ = Distribution2D(weights, static_cast<std::size_t>(width_), static_cast<std::size_t>(height_));
  mean_luminance_ = texels_.sum() / areas;
}

Vec3 SphereDistribution::sample(const Vec2& u) const {
  const Distribution2D::Draw draw = texels_.sample(u);
  const Vec2 place(static_cast<float>(draw.x) + 0.5f + tent(draw.remainder.x),
                   static_cast<float>(draw.y) + 0.5f + tent(draw.remainder.y));
  return direction_of(mapping_, folded(mapping_, place / Vec2(width_, height_)));
}

float SphereDistribution::pdf(const Vec3& direction) const {
  const float stretch = stretch_at(mapping_, direction);
  if (!(stretch > 0)) return 0;
  const float density =
      corners_at(mapping_, square_of(mapping_, direction), width_, height_).mean([&](int x, int y) {
        return texels_.probability(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
      });
  return density * static_cast<float>(width_) * static_cast<float>(height_) / stretch;
}

}  // namespace umbral
