// trace() and shade() of the lecture.
#include "integrators/blinn_phong.h"

namespace umbral {

struct BlinnPhongIntegrator::Terms {
  Spectrum diffuse = black, specular = black;
};

// The visible point: its surface, coefficients, and the directions in the frame whose z is n.
struct BlinnPhongIntegrator::Point {
  Surface surface;
  BlinnPhongCoefficients k;
  Vec3 wo;  // world, v of the formula
  Vec3 wo_local;
};

void BlinnPhongIntegrator::describe(ParameterVisitor& visitor) { for_each_parameter(*this, visitor); }

std::vector<std::string> BlinnPhongIntegrator::bias_notes() const {
  std::vector<std::string> notes{"local model: light of more than one bounce is missing"};
  if (convention == Convention::classic)
    notes.push_back("convention classic: coefficients are not radiometric");
  if (ambient && !is_black(ambient_light)) notes.push_back("ambient light is added");
  if (!ambient || !diffuse || !specular || !emission) notes.push_back("terms are switched off");
  if (!shadows) notes.push_back("shadows are off");
  if (!attenuation) notes.push_back("attenuation by distance is off");
  return notes;
}

// One light's share of the sum.
BlinnPhongIntegrator::Terms BlinnPhongIntegrator::shade(const Scene& scene, const Point& point,
                                                        const LightSample& light) const {
  const Vec3 wi = point.surface.shading.to_local(light.wi);
  Terms terms;
  if (convention == Convention::physical) {
    const BlinnPhongTerms f_cos = blinn_phong_f_cos(point.k, point.wo_local, wi);
    terms = {f_cos.diffuse, f_cos.specular};
  } else {
    const float to_viewer = point.wo_local.z < 0 ? -1.0f : 1.0f;  // n of the formula is on the viewer's side
    const float n_l = std::max(0.0f, to_viewer * wi.z);
    const Vec3 between = point.wo_local + wi;
    const float length = glm::length(between);
    const float n_h = length > 0 ? std::max(0.0f, to_viewer * between.z / length) : 0.0f;
    terms = {point.k.kd * n_l, point.k.ks * std::pow(n_h, point.k.exponent)};
  }
  if (is_black(terms.diffuse) && is_black(terms.specular)) return {};
  if (shadows) {
    // A light on the other side of the surface is in the surface's own shadow.
    if (dot(light.wi, point.surface.ng) * dot(point.wo, point.surface.ng) <= 0) return {};
    if (scene.occluded(Scene::shadow_ray(point.surface, light))) return {};
  }
  const bool unattenuated = !attenuation && std::isfinite(light.distance);
  const Spectrum irradiance = light.irradiance() * (unattenuated ? sqr(light.distance) : 1.0f);
  return {terms.diffuse * irradiance, terms.specular * irradiance};
}

Spectrum BlinnPhongIntegrator::radiance(const Scene& scene, const Ray& ray, Sampler& sampler,
                                        std::span<Spectrum> layers) const {
  Spectrum la = black, ld = black, ls = black, le = black;
  if (const std::optional<Hit> hit = scene.intersect(ray)) {
    Point point{scene.surface(ray, *hit), {}, -ray.d, {}};
    LobeStack textured;
    point.k = to_blinn_phong(scene.bsdf(point.surface, textured));
    point.wo_local = point.surface.shading.to_local(point.wo);
    if (emission) le = scene.emitted(point.surface, point.wo);
    if (ambient) la = point.k.ka * ambient_light;
    for (std::size_t i = 0; i < scene.light_count(); ++i) {
      const Vec2 u = sampler.next2d();
      const std::optional<LightSample> light =
          scene.sample_light(static_cast<LightId>(i), LightReceiver{point.surface.p, point.surface.ng}, u);
      if (!light) continue;
      const Terms terms = shade(scene, point, *light);
      if (diffuse) ld += terms.diffuse;
      if (specular) ls += terms.specular;
    }
  } else {
    le = scene.has_environment() ? scene.background(ray.d) : background;
  }
  const Spectrum parts[] = {la, ld, ls, le};
  for (std::size_t i = 0; i < layers.size(); ++i) layers[i] += parts[i];
  return la + ld + ls + le;
}

}  // namespace umbral
