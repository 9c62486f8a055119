// Building a scene and asking its lights.
#include "scene/scene.h"

#include <algorithm>
#include <set>

namespace umbral {

Scene::Scene(SceneDescription description)
    : camera_(description.camera),
      textures_(std::move(description.textures)),
      materials_(std::move(description.materials)),
      geometry_(sorted_geometry(description)) {
  mark_details();
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
  std::vector<LightFacts> lights;
  for (const Light& light : lights_) lights.push_back(facts(light));
  light_chooser_ = LightChooser(lights);
}

// What each piece's material asks for, next to what a hit reads anyway.
void Scene::mark_details() {
  const auto is_black_behind = [](const Material& material) { return material.back == BackSide::absorbing; };
  if (std::any_of(materials_.begin(), materials_.end(), is_black_behind)) {
    black_ = static_cast<MaterialId>(materials_.size());
    materials_.push_back({"black", Lambert{black}, {}, {1}});
  }
  join_parts(materials_);
  for (Group& group : geometry_.groups)
    for (Piece& piece : group.pieces)
      for_each_part(materials_[index_of(piece.material)], materials_,
                    [&](const Material& part) { piece.needs |= part.needs(textures_); });
  for (const Emitter& emitter : geometry_.emitters)
    if (!emitter.emission.is_constant())
      geometry_.groups[emitter.group].pieces[emitter.piece].needs |=
          textures_[index_of(emitter.emission.map)].needs();
  for (Group& group : geometry_.groups)
    for (Piece& piece : group.pieces) has_footprints_ |= (piece.needs & texture_needs::footprint) != 0;
  for (Group& group : geometry_.groups)
    for (Piece& piece : group.pieces)
      piece.detail = detail_of(piece, geometry_, materials_[index_of(piece.material)], materials_);
}

void Scene::add_detail(const Ray& ray, const Hit& hit, Surface& surface) const {
  umbral::add_detail(geometry_, materials_[index_of(surface.material)], textures_, ray, hit, surface);
  if ((surface.detail & surface_detail::black_back) != 0 && dot(ray.d, surface.ng) > 0)
    surface.material = black_;
}

const Lobes& Scene::varying_bsdf(const Material& material, const Surface& surface, LobeStack& storage) const {
  storage.clear();
  Lobes& lobe = varying_lobe(material, materials_, surface.at, textures_, storage);
  if ((surface.detail & surface_detail::clearcoat_normal) != 0)
    std::get<Principled>(lobe).clearcoat_normal = surface.shading.to_local(surface.clearcoat_normal);
  return lobe;
}

LightFacts Scene::facts(const Light& light) const {
  return std::visit(
      [&](const auto& kind) -> LightFacts {
        if constexpr (requires { kind.bounds(); })
          return {kind.power(), kind.bounds()};
        else
          return {kind.power(std::max(static_cast<double>(radius_), 1e-30)), std::nullopt};
      },
      light);
}

std::optional<LightSample> Scene::sample_light(LightId light, const LightReceiver& receiver,
                                               const Vec2& u) const {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.sample(receiver, u); })
          return kind.sample(receiver, u);
        else if constexpr (requires { kind.sample(u); })
          return kind.sample(u);
        else
          return kind.sample(receiver.p);
      },
      lights_[index_of(light)]);
}

float Scene::light_pdf(LightSelection selection, const LightReceiver& receiver, const Surface& surface,
                       const Hit& hit, const Vec3& wi) const {
  if (surface.light == LightId::none) return 0;
  return light_chooser_.probability(selection, receiver, surface.light) *
         area_light(surface.light).pdf(receiver, surface, hit, wi);
}

float Scene::environment_pdf(LightSelection selection, const LightReceiver& receiver, const Vec3& wi) const {
  if (!environment_) return 0;
  return light_chooser_.probability(selection, receiver, static_cast<LightId>(lights_.size() - 1)) *
         environment_->pdf(wi);
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
  if (light_chooser_.has_tree()) names.insert("light tree");
  for (const Material& material : materials_) {
    if (!material.is_opaque()) names.insert("alpha");
    if (material.back != BackSide::same) names.insert("one-sided materials");
    if (material.has_normal_map() || material.has_clearcoat_normal_map()) names.insert("normal maps");
    if (material.has_bump_map()) names.insert("bump maps");
    names.insert(std::visit([](const auto& lobe) { return std::string(lobe.kind); }, material.lobe));
  }
  return {names.begin(), names.end()};
}

}  // namespace umbral
