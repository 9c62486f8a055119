// Evaluation of the procedural textures.
#include "core/noise.h"
#include "scene/textures/marble_texture.h"
#include "scene/textures/noise_texture.h"
#include "scene/textures/stone_texture.h"
#include "scene/textures/wood_texture.h"

namespace umbral {
namespace {

Spectrum between(const NoisePlace& place, float share) {
  return mix(place.low, place.high, glm::clamp(share, 0.0f, 1.0f));
}

}  // namespace

Spectrum NoiseTexture::evaluate(const TexturePoint& point) const {
  return between(*this, 0.5f + 0.5f * fractal_noise(at(point), octaves, gain));
}

Spectrum MarbleTexture::evaluate(const TexturePoint& point) const {
  const Vec3 p = at(point);
  const float phase = p.x + turbulence * fractal_noise(p, octaves, 0.5f);
  const float wave = 0.5f + 0.5f * std::sin(two_pi * (phase - std::floor(phase)));
  return between(*this, std::pow(wave, 1 / sharpness));
}

Spectrum WoodTexture::evaluate(const TexturePoint& point) const {
  const Vec3 p = at(point);
  // Trunks change slowly along z, fibres slower still.
  const float r = std::hypot(p.x, p.y) + wobble * fractal_noise(p * Vec3(0.5f, 0.5f, 0.1f), 2, 0.5f);
  const float phase = r - std::floor(r);
  const float ring = phase < 0.85f ? sqr(phase / 0.85f) : (1 - phase) / 0.15f;
  const float fibre = 0.5f * gradient_noise(p * Vec3(12, 12, 0.4f));
  return between(*this, ring + grain * fibre);
}

Spectrum StoneTexture::evaluate(const TexturePoint& point) const {
  const NearestPoints nearest = nearest_points(at(point));
  const float from_joint = nearest.second - nearest.first;
  const float body = joint_width > 0 ? glm::smoothstep(0.5f * joint_width, joint_width, from_joint) : 1.0f;
  return mix(joint, between(*this, nearest.number), body);
}

}  // namespace umbral
