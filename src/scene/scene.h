// Scene: all that a render asks about the world; immutable once it is built.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/accel.h"
#include "scene/description.h"
#include "scene/lights/lights.h"
#include "scene/surface_detail.h"

namespace umbral {

class Scene {
 public:
  // `description` must be valid, as the readers make it. Builds in parallel.
  explicit Scene(SceneDescription description);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const CameraSettings& camera() const { return camera_; }

  // The nearest surface that the ray meets, and whether it meets any.
  std::optional<Hit> intersect(const Ray& ray) const { return accel_->intersect(ray); }
  bool occluded(const Ray& ray) const { return accel_->occluded(ray); }

  Surface surface(const Ray& ray, const Hit& hit) const {
    Surface surface = geometry_.surface(ray, hit);
    if (surface.detail != 0) add_detail(ray, hit, surface);
    return surface;
  }
  // The lobe at `surface`: the material's own, or, where something of it varies, a copy of it in `storage`.
  const Lobes& bsdf(const Surface& surface, LobeStack& storage) const {
    const Material& material = materials_[index_of(surface.material)];
    return material.varies ? varying_bsdf(material, surface, storage) : material.lobe;
  }

  // Radiance that leaves `surface` towards `wo` by emission; wo: unit, world, away from the surface.
  Spectrum emitted(const Surface& surface, const Vec3& wo) const {
    return surface.light == LightId::none ? black : area_light(surface.light).emitted(surface, wo);
  }
  // Radiance of the environment seen along `direction` (unit); black where there is none.
  Spectrum background(const Vec3& direction) const {
    return environment_ ? environment_->emitted(direction) : black;
  }

  std::size_t light_count() const { return lights_.size(); }
  bool has_environment() const { return environment_ != nullptr; }

  // One light for the receiver, by u in [0, 1); none where there are no lights, or none can shine there.
  LightChoice choose_light(LightSelection selection, const LightReceiver& receiver, float u) const {
    return light_chooser_.choose(selection, receiver, u);
  }

  // A direction from the receiver towards that light; none where it cannot shine there.
  std::optional<LightSample> sample_light(LightId light, const LightReceiver& receiver, const Vec2& u) const;
  std::optional<LightSample> sample_light(LightId light, const Vec3& p, const Vec2& u) const {
    return sample_light(light, LightReceiver{p}, u);
  }

  // The density, per solid angle, with which choose_light() and sample_light() together draw for the receiver the
  // direction `wi` that met `surface` by `hit` (or the environment). 0 where it is no light.
  float light_pdf(LightSelection selection, const LightReceiver& receiver, const Surface& surface,
                  const Hit& hit, const Vec3& wi) const;
  float environment_pdf(LightSelection selection, const LightReceiver& receiver, const Vec3& wi) const;

  // From `surface` to the sample; occluded() tells whether it arrives.
  static Ray shadow_ray(const Surface& surface, const LightSample& sample);

  // Whether any texture looks at the cone of rays (Ray::width).
  bool has_footprints() const { return has_footprints_; }

  float radius() const { return radius_; }  // of a sphere that holds the world; world units
  std::size_t accel_bytes() const { return accel_->bytes(); }
  // What the scene uses beyond plain triangles and constants, for the summary of a render.
  std::vector<std::string> features() const;

 private:
  void mark_details();
  void add_detail(const Ray& ray, const Hit& hit, Surface& surface) const;
  const Lobes& varying_bsdf(const Material& material, const Surface& surface, LobeStack& storage) const;
  const AreaLight& area_light(LightId light) const { return std::get<AreaLight>(lights_[index_of(light)]); }
  LightFacts facts(const Light& light) const;

  CameraSettings camera_;
  std::vector<Texture> textures_;
  std::vector<Material> materials_;
  MaterialId black_ = MaterialId::none;  // of inner sides that are black; none where there are no such
  Geometry geometry_;
  std::unique_ptr<Accel> accel_;
  std::vector<Light> lights_;                      // first the area lights, numbered as their emitters are
  const EnvironmentLight* environment_ = nullptr;  // in lights_
  LightChooser light_chooser_;
  float radius_ = 0;
  bool has_footprints_ = false;
};

}  // namespace umbral
