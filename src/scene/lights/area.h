// Area lights: shapes that emit.
#pragma once

#include <optional>

#include "core/distribution.h"
#include "scene/geometry.h"
#include "scene/lights/light_sample.h"

namespace umbral {

// One emitting piece at one place. Points on it are drawn uniformly by world area (for analytic shapes that are
// stretched unevenly: uniformly before the stretch, with the density that results).
class AreaLight {
 public:
  // `geometry` must outlive the light.
  AreaLight(const Geometry& geometry, const Emitter& emitter, const std::vector<Material>& materials,
            const std::vector<Texture>& textures);

  std::optional<LightSample> sample(const Vec3& p, const Vec2& u) const;

  // Of sample(), per solid angle at a point `distance` away that sees `surface`, a point of this light, along wi.
  float pdf(const Surface& surface, const Vec3& wi, float distance) const;

  // Radiance leaving `surface` towards `wo`; wo away from it, world.
  Spectrum emitted(const Surface& surface, const Vec3& wo) const;

  double power() const;  // of the mean emission over the piece, as far as it is opaque, W

 private:
  struct Point {
    Vec3 p, n;
    float error;  // as that of a Surface
    Vec2 uv;
    float pdf;  // per world area
  };

  Point mesh_point(const Vec2& u) const;
  Point rectangle_point(const Vec2& u) const;
  Point analytic_point(const Vec2& u) const;
  Point point(const Vec2& u) const;
  Vec3d world(const Vec3& p) const;
  float placed_error() const;
  float area_pdf(const Vec3& n) const;  // n: unit, world, outer side
  Spectrum emission_at(const Vec2& uv) const;
  float opacity_at(const Vec2& uv) const;
  float least_emission() const;

  const Geometry* geometry_;
  const std::vector<Texture>* textures_;
  Emitter emitter_;
  Textured<float> opacity_{1};
  const TracedMesh* mesh_ = nullptr;       // of a triangle mesh
  const PlacedShape* analytic_ = nullptr;  // of the others
  Affine to_world_, from_world_;           // from group space; from canonical space where analytic
  Distribution1D triangles_;               // by world area; empty for rectangles
  Rectangle rectangle_;                    // world
  Vec3 rectangle_normal_{0};               // unit, world, outer side
  float rectangle_error_ = 0;              // of its points
  double area_ = 0;                        // world; canonical where analytic
  float inverse_area_ = 0;
  float placed_error_ = 0;  // that an instance brings, world units; 0 without one
};

}  // namespace umbral
