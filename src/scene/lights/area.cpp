// Sampling the surface of emitting shapes.
#include "scene/lights/area.h"

#include "core/warp.h"

namespace umbral {

AreaLight::AreaLight(const Geometry& geometry, const Emitter& emitter, const std::vector<Material>& materials,
                     const std::vector<Texture>& textures)
    : geometry_(&geometry), textures_(&textures), emitter_(emitter) {
  if (emitter.instance != no_index) {
    to_world_ = geometry.instances[emitter.instance].to_world;
    from_world_ = geometry.instances[emitter.instance].from_world;
  }
  const Piece& piece = geometry.groups[emitter.group].pieces[emitter.piece];
  opacity_ = materials[index_of(piece.material)].alpha;
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
  if (!emitter.rectangle) {
    triangles_ = Distribution1D(areas);
    return;
  }
  const Rectangle& r = *emitter.rectangle;
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
}

// A point that an instance has moved is made from the numbers of its object and of the move, large as its own may not
// be.
float AreaLight::placed_error() const {
  if (emitter_.instance == no_index) return 0;
  Vec3d reach(0);  // of the piece; group space
  if (analytic_) {
    const Bounds bounds = std::visit([](const auto& shape) { return shape.bounds(); }, analytic_->shape);
    reach = analytic_->to_group.magnitude(glm::max(glm::abs(bounds.low), glm::abs(bounds.high)));
  } else {
    for (const Vertex& vertex : mesh_->vertices) reach = glm::max(reach, Vec3d(glm::abs(vertex.p)));
  }
  return surface_error(
      max_component(Vec3(geometry_->instances[emitter_.instance].to_world.magnitude(reach))));
}

Vec3d AreaLight::world(const Vec3& p) const { return to_world_.point(Vec3d(p)); }

AreaLight::Point AreaLight::rectangle_point(const Vec2& u) const {
  const Vec3 p = rectangle_.origin + u.x * rectangle_.edge_u + u.y * rectangle_.edge_v;
  return {p, rectangle_normal_, rectangle_error_, u, 0};
}

AreaLight::Point AreaLight::mesh_point(const Vec2& u) const {
  const Distribution1D::Draw draw = triangles_.sample(u.x);
  const Vec2 b = square_to_triangle({draw.remainder, u.y});
  const auto index = static_cast<std::uint32_t>(draw.index);
  const Triangle& triangle = mesh_->triangles[index];
  const glm::uvec3& t = triangle.vertices;
  const Vec3 &a = mesh_->vertices[t.x].p, &e = mesh_->vertices[t.y].p, &f = mesh_->vertices[t.z].p;
  const Vec3d p = world((1 - b.x - b.y) * a + b.x * e + b.y * f);
  const Vec3d n = cross(Vec3d(e) - Vec3d(a), Vec3d(f) - Vec3d(a));
  return {Vec3(p), Vec3(glm::normalize(from_world_.transposed(n))),
          std::max(surface_error(triangle.magnitude), placed_error_), mesh_->uv(index, b), 0};
}

AreaLight::Point AreaLight::analytic_point(const Vec2& u) const {
  const SurfacePoint s = std::visit([&](const auto& shape) { return shape.sample(u); }, analytic_->shape);
  const Vec3d p = to_world_.point(s.p);
  return {Vec3(p), Vec3(glm::normalize(from_world_.transposed(s.n))),
          std::max(surface_error(max_component(Vec3(glm::abs(p)))), placed_error_), Vec2(s.uv), 0};
}

AreaLight::Point AreaLight::point(const Vec2& u) const {
  Point point = analytic_ ? analytic_point(u) : emitter_.rectangle ? rectangle_point(u) : mesh_point(u);
  point.pdf = area_pdf(point.n);
  return point;
}

float AreaLight::area_pdf(const Vec3& n) const {
  if (!analytic_) return inverse_area_;
  // The normal before the map: n_world ∝ M⁻ᵀ n, so n ∝ Mᵀ n_world.
  const Vec3d canonical = glm::normalize(to_world_.transposed(Vec3d(n)));
  return static_cast<float>(1 / (area_ * area_stretch(to_world_, from_world_, canonical)));
}

std::optional<LightSample> AreaLight::sample(const Vec3& p, const Vec2& u) const {
  std::optional<LightSample>
      result;  // built in place: a copy of what was just stored piece by piece would stall
  const Point q = point(u);
  const Vec3 to_light = q.p - p;
  const float distance = glm::length(to_light);
  if (!(distance > 0)) return result;
  const Vec3 wi = to_light / distance;
  const float cosine = -dot(wi, q.n);  // positive on the outer side
  if (cosine == 0 || (cosine < 0 && !emitter_.two_sided)) return result;
  const float pdf = q.pdf * sqr(distance) / std::abs(cosine);
  if (!(pdf > 0) || !std::isfinite(pdf)) return result;
  result.emplace();
  result->wi = wi;
  result->radiance = emission_at(q.uv) * opacity_at(q.uv);
  result->pdf = pdf;
  result->distance = distance;
  result->target = q.p + (cosine < 0 ? -q.error : q.error) * q.n;
  return result;
}

float AreaLight::pdf(const Surface& surface, const Vec3& wi, float distance) const {
  const float cosine = -dot(wi, surface.ng);
  if (cosine == 0 || (cosine < 0 && !emitter_.two_sided)) return 0;
  return area_pdf(surface.ng) * sqr(distance) / std::abs(cosine);
}

Spectrum AreaLight::emission_at(const Vec2& uv) const {
  if (emitter_.emission.is_constant()) return emitter_.emission.value;
  return (*textures_)[index_of(emitter_.emission.map)].color(uv) * rgb(1, 1, 1);
}

// Rays meet the surface with this probability; samples, which go straight to it, carry it as a factor.
float AreaLight::opacity_at(const Vec2& uv) const {
  if (opacity_.is_constant()) return opacity_.value;
  return glm::clamp((*textures_)[index_of(opacity_.map)].number(uv), 0.0f, 1.0f);
}

Spectrum AreaLight::emitted(const Surface& surface, const Vec3& wo) const {
  if (dot(wo, surface.ng) <= 0 && !emitter_.two_sided) return black;
  return emission_at(surface.uv);
}

double AreaLight::power() const {
  // Means over a grid of samples: exact for constant emission and even stretch; else it only weighs the choice.
  constexpr int grid = 16;
  double sum = 0;
  for (int y = 0; y < grid; ++y)
    for (int x = 0; x < grid; ++x) {
      const Vec2 u{(static_cast<float>(x) + 0.5f) / grid, (static_cast<float>(y) + 0.5f) / grid};
      const Point q = point(u);
      sum += (luminance(emission_at(q.uv)) * opacity_at(q.uv) + least_emission()) / q.pdf;
    }
  return sum / (grid * grid) * pi_d * (emitter_.two_sided ? 2 : 1);
}

// A small share of a texture's brightest value: a light whose bright spots fall between the grid's samples must
// still be chosen now and then.
float AreaLight::least_emission() const {
  if (emitter_.emission.is_constant()) return 0;
  return 0.01f * luminance((*textures_)[index_of(emitter_.emission.map)].color_bounds().high);
}

}  // namespace umbral
