// Building a scene and asking its lights.
#include "scene/scene.h"

#include <numeric>
#include <set>

namespace umbral {

Scene::Scene(SceneDescription description)
    : camera_(description.camera),
      textures_(std::move(description.textures)),
      materials_(std::move(description.materials)),
      geometry_(sorted_geometry(description)) {
  accel_ = std::make_unique<Accel>(geometry_, materials_, textures_);
  const Bounds bounds = accel_->bounds();
  radius_ = static_cast<float>(std::max(0.0, glm::length(bounds.high - bounds.low) / 2));
  if (!std::isfinite(radius_)) radius_ = 0;

  for (const Emitter& emitter : geometry_.emitters)
    lights_.emplace_back(AreaLight(geometry_, emitter, materials_, textures_));
  for (const LightKinds& light : description.lights)
    std::visit([&](const auto& kind) { lights_.emplace_back(kind); }, light);
  if (description.environment) {
    lights_.emplace_back(std::move(*description.environment));
    environment_ = &std::get<EnvironmentLight>(lights_.back());
  }
  std::vector<double> powers;
  for (const Light& light : lights_) powers.push_back(power(light));
  // A share is dealt to all lights alike: a lamp's power may be as nothing against the sun's, over all the scene, and
  // the lamp be the brightest light where it stands.
  const double mean = std::accumulate(powers.begin(), powers.end(), 0.0) / static_cast<double>(powers.size());
  for (double& weight : powers)
    if (weight > 0) weight += 0.1 * mean;
  light_choice_ = Distribution1D(powers);
}

double Scene::power(const Light& light) const {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.power(1.0); })
          return kind.power(std::max(static_cast<double>(radius_), 1e-30));
        else
          return kind.power();
      },
      light);
}

Scene::LightChoice Scene::choose_light(float u) const {
  if (lights_.empty()) return {LightId::none, 0};
  if (lights_.size() == 1) return {static_cast<LightId>(0), 1};
  const Distribution1D::Draw draw = light_choice_.sample(u);
  return {static_cast<LightId>(draw.index), draw.probability};
}

std::optional<LightSample> Scene::sample_light(LightId light, const Vec3& p, const Vec2& u) const {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.sample(p, u); })
          return kind.sample(p, u);
        else if constexpr (requires { kind.sample(u); })
          return kind.sample(u);
        else
          return kind.sample(p);
      },
      lights_[index_of(light)]);
}

float Scene::light_pdf(const Surface& surface, const Vec3& wi, float distance) const {
  if (surface.light == LightId::none) return 0;
  return light_choice_.probability(index_of(surface.light)) *
         area_light(surface.light).pdf(surface, wi, distance);
}

float Scene::environment_pdf(const Vec3& wi) const {
  if (!environment_) return 0;
  return light_choice_.probability(lights_.size() - 1) * environment_->pdf(wi);
}

Ray Scene::shadow_ray(const Surface& surface, const LightSample& sample) {
  const Vec3 origin = surface.origin_towards(sample.wi);
  if (std::isinf(sample.distance)) return {origin, sample.wi};
  const Vec3 way = sample.target - origin;
  const float distance = glm::length(way);
  return {origin, way / distance, 0, distance};
}

std::vector<std::string> Scene::features() const {
  std::set<std::string> names;
  if (!textures_.empty()) names.insert("textures");
  if (!geometry_.instances.empty()) names.insert("instances");
  if (!geometry_.analytics.empty()) names.insert("analytic shapes");
  if (environment_) names.insert("environment");
  for (const Material& material : materials_) {
    if (!material.is_opaque()) names.insert("alpha");
    names.insert(std::visit([](const auto& lobe) { return std::string(lobe.kind); }, material.lobe));
  }
  return {names.begin(), names.end()};
}

}  // namespace umbral
