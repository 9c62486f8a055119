// Sampling the surface of emitting shapes; of meshes in area_mesh.cpp.
#include "scene/lights/area.h"

#include "core/warp.h"
#include "scene/lights/near_light.h"

namespace umbral {

AreaLight::AreaLight(const Geometry& geometry, const Emitter& emitter, const std::vector<Material>& materials,
                     const std::vector<Texture>& textures)
    : geometry_(&geometry), textures_(&textures), emitter_(emitter) {
  if (emitter.instance != no_index) {
    to_world_ = geometry.instances[emitter.instance].to_world;
    from_world_ = geometry.instances[emitter.instance].from_world;
  }
  const Piece& piece = geometry.groups[emitter.group].pieces[emitter.piece];
  material_ = &materials[index_of(piece.material)];
  if (material_->back == BackSide::clear) emitter_.two_sided = false;  // no ray meets its inner side
  needs_ = piece.needs;
  textured_ = !emitter.emission.is_constant() || !material_->alpha.is_constant();
  if (!textured_) constant_shine_ = emitter.emission.value * material_->opacity({}, textures);
  if (piece.analytic != no_index) {
    analytic_ = &geometry.analytics[piece.analytic];
    to_world_ = to_world_ * analytic_->to_group;
    from_world_ = inverse(to_world_);
    area_ = std::visit([](const auto& shape) { return shape.area(); }, analytic_->shape);
    placed_error_ = placed_error();
    return;
  }
  mesh_ = &geometry.meshes[piece.mesh];
  placed_error_ = placed_error();
  std::vector<double> areas;
  areas.reserve(mesh_->triangles.size());
  for (const Triangle& triangle : mesh_->triangles) {
    const glm::uvec3& t = triangle.vertices;
    const Vec3d a = world(mesh_->vertices[t.x].p);
    areas.push_back(glm::length(cross(world(mesh_->vertices[t.y].p) - a, world(mesh_->vertices[t.z].p) - a)) /
                    2);
    area_ += areas.back();
  }
  inverse_area_ = static_cast<float>(1 / area_);
  if (emitter.rectangle) {
    prepare_rectangle(*emitter.rectangle);
    return;
  }
  triangles_ = Distribution1D(areas);
  if (emitter.instance != no_index || areas.size() < 2) return;
  std::vector<LightBounds> bounds;
  for (std::uint32_t i = 0; i < areas.size(); ++i) bounds.push_back(triangle_bounds(i));
  triangle_tree_ = LightTree(bounds);
}

void AreaLight::prepare_rectangle(const Rectangle& r) {
  rectangle_ = {Vec3(world(r.origin)), Vec3(to_world_.vector(Vec3d(r.edge_u))),
                Vec3(to_world_.vector(Vec3d(r.edge_v)))};
  // Of its triangles: they were turned where a mirror turned the edges.
  const glm::uvec3& t = mesh_->triangles[0].vertices;
  const Vec3d corner(mesh_->vertices[t.x].p);
  const Vec3d normal = cross(Vec3d(mesh_->vertices[t.y].p) - corner, Vec3d(mesh_->vertices[t.z].p) - corner);
  rectangle_error_ =
      std::max(surface_error(max_component(glm::abs(rectangle_.origin) + glm::abs(rectangle_.edge_u) +
                                           glm::abs(rectangle_.edge_v))),
               placed_error_);
  rectangle_normal_ = Vec3(glm::normalize(from_world_.transposed(normal)));
  rectangle_middle_ = rectangle_.origin + (rectangle_.edge_u + rectangle_.edge_v) / 2.0f;
  const Vec3d u(rectangle_.edge_u), v(rectangle_.edge_v);
  const bool is_rectangular = std::abs(dot(u, v)) <= 1e-6 * glm::length(u) * glm::length(v);
  near_distance2_ = is_rectangular ? static_cast<float>(near_areas * area_) : 0;
}

Vec3d AreaLight::world(const Vec3& p) const { return to_world_.point(Vec3d(p)); }

AreaLight::Point AreaLight::rectangle_point(const Vec2& u) const {
  const Vec3 p = rectangle_.origin + u.x * rectangle_.edge_u + u.y * rectangle_.edge_v;
  return {p, rectangle_normal_, rectangle_error_, u, 0};
}

// What its textures see, worked out only where there are any.
TexturePoint AreaLight::texture_point(const Point& q) const {
  if (mesh_ && !emitter_.rectangle) return mesh_->texture_point(q.triangle, q.place, needs_);
  TexturePoint point = q.place;
  if (needs_ == 0) return point;
  point.uv1 = point.uv;
  if (analytic_) {
    point.p = Vec3(analytic_->to_group.point(from_world_.point(Vec3d(q.p))));
  } else {
    const Rectangle& r = *emitter_.rectangle;
    point.p = r.origin + q.place.x * r.edge_u + q.place.y * r.edge_v;
  }
  return point;
}

Spectrum AreaLight::shine(const Point& q) const {
  if (!textured_) return constant_shine_;
  const TexturePoint point = texture_point(q);
  return emission_at(point) * opacity_at(point);
}

AreaLight::Point AreaLight::analytic_point(const Vec2& u) const {
  const SurfacePoint s = std::visit([&](const auto& shape) { return shape.sample(u); }, analytic_->shape);
  const Vec3d p = to_world_.point(s.p);
  return {Vec3(p), Vec3(glm::normalize(from_world_.transposed(s.n))),
          std::max(surface_error(max_component(Vec3(glm::abs(p)))), placed_error_), Vec2(s.uv), 0};
}

AreaLight::Point AreaLight::point(const Vec2& u) const {
  Point point;
  if (analytic_) {
    point = analytic_point(u);
  } else if (emitter_.rectangle) {
    point = rectangle_point(u);
  } else {
    const Distribution1D::Draw draw = triangles_.sample(u.x);
    point = triangle_point(static_cast<std::uint32_t>(draw.index), square_to_triangle({draw.remainder, u.y}));
  }
  point.pdf = area_pdf(point.n);
  return point;
}

std::optional<SphereCone> AreaLight::cone_from(const Vec3& p) const {
  if (!std::holds_alternative<Sphere>(analytic_->shape)) return std::nullopt;
  const Vec3d canonical = from_world_.point(Vec3d(p));
  if (!(dot(canonical, canonical) > 1 + 1e-6)) return std::nullopt;
  return SphereCone(canonical);
}

// Directions are stretched, too: dω/dω' = |det M⁻¹| / |M⁻¹ ω|³ for a unit vector ω of the world.
float AreaLight::cone_pdf_along(const SphereCone& cone, const Vec3& wi) const {
  const double length = glm::length(from_world_.vector(Vec3d(wi)));
  return static_cast<float>(cone.pdf() * std::abs(from_world_.determinant()) / (length * length * length));
}

AreaLight::Point AreaLight::sphere_point(const Vec3& p, const SphereCone& cone, const Vec2& u) const {
  const Vec3d n = cone.sample(u);
  const Vec3d q = to_world_.point(n);
  Vec2 uv{0, 0};
  if (textured_) uv = Vec2(std::get<Sphere>(analytic_->shape).nearest(n).uv);
  return {Vec3(q),
          Vec3(glm::normalize(from_world_.transposed(n))),
          std::max(surface_error(max_component(Vec3(glm::abs(q)))), placed_error_),
          uv,
          cone_pdf_along(cone, Vec3(glm::normalize(q - Vec3d(p)))),
          true};
}

std::optional<SphericalRectangle> AreaLight::rectangle_from(const Vec3& p) const {
  const Vec3 way = p - rectangle_middle_;
  if (!(dot(way, way) < near_distance2_)) return std::nullopt;
  const Vec3d u(rectangle_.edge_u), v(rectangle_.edge_v);
  const glm::dvec2 length(glm::length(u), glm::length(v));
  const SphericalRectangle seen(Vec3d(p), Vec3d(rectangle_.origin), u / length.x, v / length.y, length);
  return is_known_solid_angle(seen.solid_angle()) ? std::optional(seen) : std::nullopt;
}

AreaLight::Point AreaLight::point_for(const LightReceiver& receiver, const Vec2& u) const {
  if (emitter_.rectangle) {
    if (const auto seen = rectangle_from(receiver.p)) {
      Point point = rectangle_point(Vec2(seen->sample(u)));
      point.pdf = static_cast<float>(1 / seen->solid_angle());
      point.by_solid_angle = true;
      return point;
    }
  } else if (!analytic_) {
    return mesh_point(receiver, u);
  } else if (const auto cone = cone_from(receiver.p)) {
    return sphere_point(receiver.p, *cone, u);
  }
  return point(u);
}

float AreaLight::area_pdf(const Vec3& n) const {
  if (!analytic_) return inverse_area_;
  // The normal before the map: n_world ∝ M⁻ᵀ n, so n ∝ Mᵀ n_world.
  const Vec3d canonical = glm::normalize(to_world_.transposed(Vec3d(n)));
  return static_cast<float>(1 / (area_ * area_stretch(to_world_, from_world_, canonical)));
}

std::optional<LightSample> AreaLight::sample(const LightReceiver& receiver, const Vec2& u) const {
  std::optional<LightSample>
      result;  // built in place: a copy of what was just stored piece by piece would stall
  const Point q = point_for(receiver, u);
  const Vec3 to_light = q.p - receiver.p;
  const float distance = glm::length(to_light);
  if (!(distance > 0)) return result;
  const Vec3 wi = to_light / distance;
  const float cosine = -dot(wi, q.n);  // positive on the outer side
  if (cosine == 0 || (cosine < 0 && !emitter_.two_sided)) return result;
  const float pdf = q.by_solid_angle ? q.pdf : q.pdf * sqr(distance) / std::abs(cosine);
  if (!(pdf > 0) || !std::isfinite(pdf)) return result;
  result.emplace();
  result->wi = wi;
  result->radiance = shine(q);
  result->pdf = pdf;
  result->distance = distance;
  result->target = q.p + (cosine < 0 ? -q.error : q.error) * q.n;
  return result;
}

float AreaLight::pdf(const LightReceiver& receiver, const Surface& surface, const Hit& hit,
                     const Vec3& wi) const {
  const float cosine = -dot(wi, surface.ng);
  if (cosine == 0 || (cosine < 0 && !emitter_.two_sided)) return 0;
  const float area_to_angle = sqr(hit.t) / std::abs(cosine);
  if (emitter_.rectangle) {
    if (const auto seen = rectangle_from(receiver.p)) return static_cast<float>(1 / seen->solid_angle());
  } else if (!analytic_) {
    return mesh_pdf(receiver, hit, area_to_angle);
  } else if (const auto cone = cone_from(receiver.p)) {
    return cone_pdf_along(*cone, wi);
  }
  return area_pdf(surface.ng) * area_to_angle;
}

Spectrum AreaLight::emission_at(const TexturePoint& point) const {
  if (emitter_.emission.is_constant()) return emitter_.emission.value;
  return (*textures_)[index_of(emitter_.emission.map)].color(point) * rgb(1, 1, 1);
}

// Rays meet the surface with this probability; samples, which go straight to it, carry it as a factor.
float AreaLight::opacity_at(const TexturePoint& point) const { return material_->opacity(point, *textures_); }

Spectrum AreaLight::emitted(const Surface& surface, const Vec3& wo) const {
  if (dot(wo, surface.ng) <= 0 && !emitter_.two_sided) return black;
  return emission_at(surface.at);
}

}  // namespace umbral
