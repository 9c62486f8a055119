// Area lights: shapes that emit.
#pragma once

#include <optional>

#include "core/distribution.h"
#include "scene/geometry.h"
#include "scene/lights/light_sample.h"
#include "scene/lights/light_tree.h"
#include "scene/lights/sphere_cone.h"
#include "scene/lights/spherical_rectangle.h"
#include "scene/lights/spherical_triangle.h"

namespace umbral {

// One emitting piece at one place. Spheres seen from outside are sampled uniformly in their solid angle (stretched ones
// uniformly before the stretch), rectangles and triangles that are large, seen from where light is asked for, too.
// Points on all else are drawn uniformly by world area (by that before an uneven stretch). The triangles of a mesh in
// the world itself are chosen by a light tree, those of an instance by area.
class AreaLight {
 public:
  // All but the emitter must outlive the light.
  AreaLight(const Geometry& geometry, const Emitter& emitter, const std::vector<Material>& materials,
            const std::vector<Texture>& textures);

  std::optional<LightSample> sample(const LightReceiver& receiver, const Vec2& u) const;

  // Of sample(), per solid angle at the receiver, from where a ray along wi met this light by `hit` at `surface`.
  float pdf(const LightReceiver& receiver, const Surface& surface, const Hit& hit, const Vec3& wi) const;

  // Radiance leaving `surface` towards `wo`; wo away from it, world.
  Spectrum emitted(const Surface& surface, const Vec3& wo) const;

  double power() const;  // of the mean emission over the piece, as far as it is opaque, W
  LightBounds bounds() const;

 private:
  struct Point {
    Vec3 p, n;
    float error;                  // as that of a Surface
    Vec2 place;                   // uv, or barycentric coordinates of a triangle of a mesh
    float pdf = 0;                // per world area, or
    bool by_solid_angle = false;  // per solid angle
    std::uint32_t triangle = 0;   // of a mesh
  };
  struct Corners {
    Vec3d a, b, c;  // world
    double area() const { return glm::length(cross(b - a, c - a)) / 2; }
  };

  // By area, wherever light is asked for.
  Point point(const Vec2& u) const;
  Point rectangle_point(const Vec2& u) const;
  Point analytic_point(const Vec2& u) const;
  Point triangle_point(std::uint32_t triangle, const Vec2& barycentric) const;

  // For the receiver.
  Point point_for(const LightReceiver& receiver, const Vec2& u) const;
  Point sphere_point(const Vec3& p, const SphereCone& cone, const Vec2& u) const;
  Point mesh_point(const LightReceiver& receiver, const Vec2& u) const;

  // What is seen from p; none where sampling by area serves as well or better.
  std::optional<SphereCone> cone_from(const Vec3& p) const;
  std::optional<SphericalRectangle> rectangle_from(const Vec3& p) const;
  static std::optional<SphericalTriangle> triangle_from(const Vec3& p, const Corners& corners);

  float cone_pdf_along(const SphereCone& cone, const Vec3& wi) const;
  float mesh_pdf(const LightReceiver& receiver, const Hit& hit, float area_to_angle) const;
  Corners corners_of(std::uint32_t triangle) const;
  LightBounds triangle_bounds(std::uint32_t triangle) const;
  void prepare_rectangle(const Rectangle& rectangle);
  Vec3d world(const Vec3& p) const;
  float placed_error() const;
  float area_pdf(const Vec3& n) const;  // n: unit, world, outer side
  Spectrum emission_at(const TexturePoint& point) const;
  float opacity_at(const TexturePoint& point) const;
  Spectrum shine(const Point& q) const;  // emission, as far as it is opaque there
  TexturePoint texture_point(const Point& q) const;
  float least_emission() const;

  const Geometry* geometry_;
  const std::vector<Texture>* textures_;
  Emitter emitter_;
  const Material* material_;
  unsigned needs_ = 0;                     // of its textures, beside uv
  bool textured_ = false;                  // shine() is not the same everywhere
  Spectrum constant_shine_{0.0f};          // where it is
  const TracedMesh* mesh_ = nullptr;       // of a triangle mesh
  const PlacedShape* analytic_ = nullptr;  // of the others
  Affine to_world_, from_world_;           // from group space; from canonical space where analytic
  Distribution1D triangles_;               // by world area; empty for rectangles
  LightTree triangle_tree_;                // empty for rectangles and in instances
  Rectangle rectangle_;                    // world
  Vec3 rectangle_normal_{0};               // unit, world, outer side
  float rectangle_error_ = 0;              // of its points
  Vec3 rectangle_middle_{0};               // world
  float near_distance2_ = 0;  // of the middle: within, a rectangle is large; 0 where not rectangular
  double area_ = 0;           // world; canonical where analytic
  float inverse_area_ = 0;
  float placed_error_ = 0;  // that an instance brings, world units; 0 without one
};

}  // namespace umbral
