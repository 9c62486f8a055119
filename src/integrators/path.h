// The path tracer: an unbiased estimate of the rendering equation.
#pragma once

#include <array>
#include <tuple>

#include "integrators/integrator.h"

namespace umbral {

// How the direct light of each vertex is found: by directions drawn by the surface, by the lights, or by both,
// joined by multiple importance sampling. All have the same mean; lights without size are always asked for
// directly, and mirrors always draw their own direction.
enum class Strategy { mis, bsdf, light };

template <>
struct EnumNames<Strategy> {
  static constexpr std::array names{"mis", "bsdf", "light"};
};

// L_o = L_e + ∫ f L_i |cos θ| dω [Kajiya 1986] along one random path: at each vertex the emission met, one light
// sample, one BSDF sample. The power heuristic with β = 2 [Veach 1997, §9.2] weighs the two ways to reach a light.
class PathIntegrator : public Integrator {
 public:
  int max_depth = 0;
  Strategy strategy = Strategy::mis;
  int roulette_depth = 3;
  LightSelection light_choice = LightSelection::tree;

  static constexpr const char* kind = "path";
  static constexpr const char* doc = "global illumination: unbiased path tracing";
  static constexpr auto parameters = std::tuple{
      parameter<&PathIntegrator::max_depth>(
          "max_depth", "bounces at most; 0 is no limit, any other number is a bias, written into the image",
          Range{0, 1 << 20}),
      parameter<&PathIntegrator::strategy>("strategy", "how light is found"),
      parameter<&PathIntegrator::roulette_depth>(
          "roulette_depth", "bounces before Russian roulette may end a path", Range{0, 1 << 20}),
      parameter<&PathIntegrator::light_choice>(
          "light_choice", "which light a vertex asks: by a light tree, by power, or all alike")};

  void describe(ParameterVisitor& visitor) override;
  std::vector<std::string> layers() const override { return {"emission", "direct", "indirect"}; }
  std::vector<std::string> bias_notes() const override;
  Spectrum radiance(const Scene& scene, const Ray& ray, Sampler& sampler,
                    std::span<Spectrum> layers) const override;
};

}  // namespace umbral
