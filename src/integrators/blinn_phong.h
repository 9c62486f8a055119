// The local illumination model of the lecture.
#pragma once

#include <array>
#include <tuple>

#include "integrators/integrator.h"

namespace umbral {

// classic:  L = ka Ia + Σ_i E_i [kd max(0, n·l_i) + ks max(0, n·h_i)^p], E_i = I_i/r_i², to the letter;
// physical: the same coefficients as an energy-conserving lobe with its cosine (bsdf/lobes/blinn_phong.h), which for
//           matte and Blinn-Phong materials and Ia = 0 is the rendering equation cut at one bounce.
enum class Convention { classic, physical };

template <>
struct EnumNames<Convention> {
  static constexpr std::array names{"classic", "physical"};
};

// Every light is asked for one sample at each visible point (an area light so casts soft shadows), every material
// for its local counterpart. n is turned to the viewer. Light that surfaces emit, and the background where nothing
// is hit, stand beside the formula in a layer of their own, `emission`.
class BlinnPhongIntegrator : public Integrator {
 public:
  Convention convention = Convention::classic;
  Spectrum ambient_light = black;
  Spectrum background = black;
  bool ambient = true, diffuse = true, specular = true, emission = true;
  bool shadows = true;
  bool attenuation = true;

  static constexpr const char* kind = "blinn_phong";
  static constexpr const char* doc = "local illumination: the Blinn-Phong model, lights and shadows only";
  static constexpr auto parameters = std::tuple{
      parameter<&BlinnPhongIntegrator::convention>("convention",
                                                   "classic: the formula; physical: energy-conserving"),
      parameter<&BlinnPhongIntegrator::ambient_light>("ambient_light", "Ia, the light that is everywhere",
                                                      non_negative),
      parameter<&BlinnPhongIntegrator::background>(
          "background", "colour where nothing is hit and there is no environment", non_negative),
      parameter<&BlinnPhongIntegrator::ambient>("ambient", "whether ka Ia is added"),
      parameter<&BlinnPhongIntegrator::diffuse>("diffuse", "whether the kd term is added"),
      parameter<&BlinnPhongIntegrator::specular>("specular", "whether the ks term is added"),
      parameter<&BlinnPhongIntegrator::emission>("emission", "whether surfaces that emit are seen to"),
      parameter<&BlinnPhongIntegrator::shadows>("shadows", "whether light is blocked by what is in between"),
      parameter<&BlinnPhongIntegrator::attenuation>("attenuation",
                                                    "whether light falls with the square of the distance")};

  void describe(ParameterVisitor& visitor) override;
  std::vector<std::string> layers() const override { return {"ambient", "diffuse", "specular", "emission"}; }
  std::vector<std::string> bias_notes() const override;
  Spectrum radiance(const Scene& scene, const Ray& ray, Sampler& sampler,
                    std::span<Spectrum> layers) const override;

 private:
  struct Terms;
  struct Point;

  Terms shade(const Scene& scene, const Point& point, const LightSample& light) const;
};

}  // namespace umbral
