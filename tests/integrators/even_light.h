// Even light all around, maps of normals without sense, and what is seen of a surface by many paths.
#pragma once

#include "integrators/path.h"
#include "scene/worlds.h"
#include "support/random.h"

namespace umbral::test {

inline void light_evenly(SceneDescription& scene) {
  scene.environment.emplace();
  scene.environment->radiance = grey(1);
  scene.environment->prepare();
}

/// A picture of normals that lean up to 70° any way, without any sense from texel to texel.
inline TextureId rough_normals(SceneDescription& scene) {
  Random random(1);
  TexelGrid<Float4> texels(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const double z = random.between(std::cos(1.2), 1), phi = random.between(0, 2 * pi_d);
      const Vec3d n(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
      texels.set(x, y, Spectrum(Vec3(n * 0.5 + 0.5), 1));
    }
  ImageTexture map;
  map.image = std::make_shared<TextureImage>(TextureImage::Texels(std::move(texels)));
  map.filter = TextureFilter::nearest;
  map.uv_scale = {4, 2};
  return add_texture(scene, map);
}

struct Seen {
  double mean, error;  // of radiance, and its standard error
};

/// Along rays that meet the shape around `target` from `from`.
inline Seen radiance(const Scene& scene, const Vec3& from, const Vec3& target, int samples,
                     std::uint64_t seed) {
  PathIntegrator path;
  path.prepare(scene);
  const Ray ray{from, glm::normalize(target - from)};
  double sum = 0, squares = 0;
  for (int i = 0; i < samples; ++i) {
    Sampler sampler(SamplerKind::independent, {seed, 0, 0, 0, static_cast<std::uint64_t>(i)});
    const double value = static_cast<double>(path.radiance(scene, ray, sampler, {}).g);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / samples;
  return {mean, std::sqrt(std::max(0.0, squares / samples - mean * mean) / samples)};
}

}  // namespace umbral::test
