// What is to be known of an area light as a whole: where it is, which way it faces, how strong it is.
#include "core/warp.h"
#include "scene/lights/area.h"

namespace umbral {
namespace {

// A cone around the normals of triangles, and the area of their mean: how much of the light there is from afar.
struct Facing {
  DirectionCone normals;
  Vec3d sum{0};
  bool any = false;

  void add(const Vec3d& area_normal) {
    const double area = glm::length(area_normal);
    if (!(area > 0)) return;
    const DirectionCone normal{area_normal / area, 1e-6};
    normals = any ? cone_around(normals, normal, false) : normal;
    any = true;
    sum += area_normal;
  }
};

void extend(Bounds& box, const Vec3d& p) {
  box.low = glm::min(box.low, p);
  box.high = glm::max(box.high, p);
}

}  // namespace

// I = L A from the front of a flat light, L A/4 of a convex closed one.
LightBounds AreaLight::bounds() const {
  LightBounds bounds;
  Facing facing;
  double area = 0;
  if (analytic_) {
    const Bounds box = std::visit([](const auto& shape) { return shape.bounds(); }, analytic_->shape);
    for (int i = 0; i < 8; ++i)
      extend(bounds.box, to_world_.point({i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                                          i & 4 ? box.high.z : box.low.z}));
    area = area_;
    if (std::holds_alternative<Disk>(analytic_->shape))
      facing.add(glm::normalize(from_world_.transposed({0, 0, 1})) * area);
  } else {
    for (std::uint32_t i = 0; i < mesh_->triangles.size(); ++i) {
      const Corners t = corners_of(i);
      for (const Vec3d& corner : {t.a, t.b, t.c}) extend(bounds.box, corner);
      // A map that mirrors turns the triangle, but not its outer side.
      const Vec3d n = cross(t.b - t.a, t.c - t.a) / 2.0;
      facing.add(to_world_.determinant() < 0 ? -n : n);
      area += glm::length(n);
    }
  }
  bounds.radius = glm::length(bounds.box.high - bounds.box.low) / 2;
  if (facing.any) bounds.normals = facing.normals;
  bounds.two_sided = emitter_.two_sided;
  const double flatness = area > 0 ? std::max(glm::length(facing.sum) / area, 0.25) : 0.25;
  bounds.intensity = power() / (pi_d * (emitter_.two_sided ? 2 : 1)) * (facing.any ? flatness : 0.25);
  return bounds;
}

LightBounds AreaLight::triangle_bounds(std::uint32_t triangle) const {
  const Corners t = corners_of(triangle);
  LightBounds bounds;
  for (const Vec3d& corner : {t.a, t.b, t.c}) extend(bounds.box, corner);
  bounds.radius = glm::length(bounds.box.high - bounds.box.low) / 2;
  const Vec3d n = cross(t.b - t.a, t.c - t.a);
  const double length = glm::length(n);
  if (!(length > 0)) return bounds;  // without intensity
  bounds.normals = {n / length, 1e-6};
  bounds.two_sided = emitter_.two_sided;
  const TexturePoint middle = mesh_->texture_point(triangle, Vec2(1.0f / 3), needs_);
  bounds.intensity = length / 2 * (luminance(emission_at(middle)) * opacity_at(middle) + least_emission());
  return bounds;
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

double AreaLight::power() const {
  // Means over a grid of samples: exact for constant emission and even stretch; else it only weighs the choice.
  constexpr int grid = 16;
  double sum = 0;
  for (int y = 0; y < grid; ++y)
    for (int x = 0; x < grid; ++x) {
      const Vec2 u{(static_cast<float>(x) + 0.5f) / grid, (static_cast<float>(y) + 0.5f) / grid};
      const Point q = point(u);
      sum += (luminance(shine(q)) + least_emission()) / q.pdf;
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
