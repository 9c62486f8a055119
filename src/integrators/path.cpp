// The path loop.
#include "integrators/path.h"

#include "integrators/multiple_importance.h"

namespace umbral {
namespace {

// Whether the shading and the true surface agree on which side `wi` leaves by; wo and `local`, which is wi, are local. An
// opaque material whose clearcoat leans on it reflects towards where it faces away itself, too.
bool sides_agree(const Surface& surface, const Lobes& lobe, const Vec3& wo, const Vec3& wi,
                 const Vec3& local) {
  const bool outside = dot(wi, surface.ng) > 0;
  if (outside == (local.z > 0)) return true;
  const bool coat_leans = (surface.detail & surface_detail::clearcoat_normal) != 0;
  return coat_leans && !transmits(lobe) && outside == (wo.z > 0);
}

// Probability to go on: the path's weight itself, so that paths that matter little end and the others weigh the
// same; never below 1/20, which bounds the weight that a survivor gets, and never 1, so that light that is trapped
// without loss (in glass beyond the critical angle, between perfect mirrors) ends too.
float survival_probability(const Spectrum& throughput) {
  return glm::clamp(max_component(throughput), 0.05f, 0.99f);
}

// By how much the cone of rays widens at a bounce: a direction of density p stands for a solid angle 1/p of 64 alike.
float spread_of(float pdf) { return 0.25f / std::sqrt(pi * pdf); }

// How the path came to where it is: what multiple importance sampling needs to know of the last bounce.
struct Arrival {
  float pdf = 0;         // of the direction, per solid angle
  bool delta = true;     // no light sample could have come this way: from the camera, or off a mirror
  LightReceiver from{};  // the vertex before
};

float light_weight(Strategy strategy, float light_pdf, float bsdf_pdf, bool delta) {
  if (delta || strategy == Strategy::light) return 1;
  return strategy == Strategy::bsdf ? 0 : power_heuristic(light_pdf, bsdf_pdf);
}

float bsdf_weight(Strategy strategy, float bsdf_pdf, float light_pdf) {
  if (strategy == Strategy::mis) return power_heuristic(bsdf_pdf, light_pdf);
  return strategy == Strategy::bsdf ? 1 : 0;
}

// What lies beyond a surface for a path that goes through it; the path begins in a void. Bodies within each other are
// not remembered: behind each face is what that face says.
Absorption beyond(const Lobes& lobe, const Vec3& wi, const Absorption& here) {
  const std::optional<Absorption> inside = interior(lobe);
  if (!inside) return here;
  return wi.z < 0 ? *inside : Absorption{};
}

// What lights are told of a vertex; wo is local. A lobe that does not transmit takes light from the side of wo alone.
LightReceiver receiver_at(const Surface& surface, const Lobes& lobe, const Vec3& wo) {
  return {surface.p, wo.z < 0 ? -surface.ng : surface.ng, !transmits(lobe)};
}

// Light that one sample of one light brings to a vertex, before the path's throughput; wo is local, `medium` is where
// the path comes from.
Spectrum direct(const PathIntegrator& settings, const Scene& scene, const Surface& surface, const Lobes& lobe,
                const Vec3& wo, const LightReceiver& receiver, const Absorption& medium, Sampler& sampler) {
  const Vec2 u = sampler.next2d();
  const float u_light = scene.light_count() > 1 ? sampler.next1d() : 0.0f;
  const LightChoice choice = scene.choose_light(settings.light_choice, receiver, u_light);
  if (choice.light == LightId::none) return black;
  const std::optional<LightSample> sample = scene.sample_light(choice.light, receiver, u);
  if (!sample) return black;
  const Vec3 wi = surface.shading.to_local(sample->wi);
  if (!sides_agree(surface, lobe, wo, sample->wi, wi)) return black;
  const Spectrum f_cos = umbral::f_cos(lobe, wo, wi);
  if (is_black(f_cos)) return black;
  const float light_pdf = choice.probability * sample->pdf;
  const float weight = light_weight(settings.strategy, light_pdf, umbral::pdf(lobe, wo, wi), sample->delta);
  if (weight == 0 || is_black(sample->radiance)) return black;
  if (scene.occluded(Scene::shadow_ray(surface, *sample))) return black;
  const Spectrum light = f_cos * sample->radiance * (weight / light_pdf);
  if (same_side(wo, wi) && !medium.absorbs()) return light;
  const Absorption& way = same_side(wo, wi) ? medium : beyond(lobe, wi, medium);
  return light * way.transmittance(sample->distance);
}

}  // namespace

void PathIntegrator::describe(ParameterVisitor& visitor) { for_each_parameter(*this, visitor); }

std::vector<std::string> PathIntegrator::bias_notes() const {
  if (max_depth == 0) return {};
  return {"max_depth = " + std::to_string(max_depth) + ": light of more bounces is missing"};
}

Spectrum PathIntegrator::radiance(const Scene& scene, const Ray& camera_ray, Sampler& sampler,
                                  std::span<Spectrum> layers) const {
  Ray ray = camera_ray;
  Spectrum result = black, throughput = white;
  Arrival arrival;
  Absorption medium;
  const auto add = [&](const Spectrum& light, int bounces) {
    result += light;
    if (!layers.empty()) layers[static_cast<std::size_t>(std::min(bounces, 2))] += light;
  };

  for (int bounces = 0;; ++bounces) {
    const std::optional<Hit> hit = scene.intersect(ray);
    if (!hit) {
      if (!scene.has_environment() || medium.absorbs()) break;
      const float weight =
          arrival.delta
              ? 1
              : bsdf_weight(strategy, arrival.pdf, scene.environment_pdf(light_choice, arrival.from, ray.d));
      if (weight > 0) add(throughput * scene.background(ray.d) * weight, bounces);
      break;
    }

    const Surface surface = scene.surface(ray, *hit);
    if (medium.absorbs()) throughput *= medium.transmittance(glm::length(surface.p - arrival.from.p));
    if (surface.light != LightId::none) {
      const float weight =
          arrival.delta ? 1
                        : bsdf_weight(strategy, arrival.pdf,
                                      scene.light_pdf(light_choice, arrival.from, surface, *hit, ray.d));
      if (weight > 0) add(throughput * scene.emitted(surface, -ray.d) * weight, bounces);
    }
    if (max_depth > 0 && bounces == max_depth) break;

    LobeStack textured;
    const Lobes& lobe = scene.bsdf(surface, textured);
    const Vec3 wo = surface.shading.to_local(-ray.d);
    const LightReceiver receiver = receiver_at(surface, lobe, wo);
    if (scene.light_count() > 0 && !only_delta(lobe))
      add(throughput * direct(*this, scene, surface, lobe, wo, receiver, medium, sampler), bounces + 1);

    const Vec2 u = sampler.next2d();
    const float u_lobe = has_choice(lobe) ? sampler.next1d() : 0.0f;
    const std::optional<BsdfSample> sample = umbral::sample(lobe, wo, u_lobe, u);
    if (!sample) break;
    const Vec3 wi = surface.shading.to_world(sample->wi);
    if (!sides_agree(surface, lobe, wo, wi, sample->wi)) break;
    throughput *= sample->weight;
    if (is_black(throughput)) break;
    if (bounces >= roulette_depth) {
      const float survival = survival_probability(throughput);
      if (sampler.next1d() >= survival) break;
      throughput /= survival;
    }
    if (!same_side(wo, sample->wi)) medium = beyond(lobe, sample->wi, medium);
    arrival = {sample->pdf, sample->delta, receiver};
    if (scene.has_footprints()) {
      ray.width += ray.spread * hit->t;
      if (!sample->delta) ray.spread = std::max(ray.spread, spread_of(sample->pdf));
    }
    ray.o = surface.origin_towards(wi);
    ray.d = wi;
  }
  return result;
}

}  // namespace umbral
