// Sorting shapes into groups and making surfaces from hits.
#include "scene/geometry.h"

#include "core/parallel.h"
#include "scene/description.h"

namespace umbral {
namespace {

// A mesh before it becomes a TracedMesh of the same number.
struct PlacedMesh {
  Mesh mesh;
  Affine to_group;
};

// Puts one shape after the other into a group.
class GroupBuilder {
 public:
  GroupBuilder(Geometry& geometry, std::vector<PlacedMesh>& meshes, std::uint32_t group)
      : geometry_(geometry), meshes_(meshes), group_(group) {}

  void add(Shape& shape) {
    Piece piece;
    piece.material = shape.material;
    std::optional<Rectangle> rectangle;
    std::visit([&](auto& kind) { place(kind, shape.to_world, piece, rectangle); }, shape.kind);
    if (shape.emits()) {
      piece.emitter = static_cast<std::uint32_t>(emitters_.size());
      const auto index = static_cast<std::uint32_t>(geometry_.groups[group_].pieces.size());
      emitters_.push_back({no_index, group_, index, shape.emission, shape.two_sided, rectangle});
    }
    geometry_.groups[group_].pieces.push_back(piece);
  }

  const std::vector<Emitter>& emitters() const { return emitters_; }

 private:
  void place_mesh(Mesh mesh, const Affine& to_group, Piece& piece) {
    piece.mesh = static_cast<std::uint32_t>(meshes_.size());
    meshes_.push_back({std::move(mesh), to_group});
  }

  template <class Kind>
  void place(Kind& kind, const Affine& to_group, Piece& piece, std::optional<Rectangle>& rectangle) {
    if constexpr (std::is_same_v<Kind, Mesh>) {
      place_mesh(std::move(kind), to_group, piece);
    } else if constexpr (ParametricShape<Kind>) {
      const Affine placed = to_group * kind.placement();
      piece.analytic = static_cast<std::uint32_t>(geometry_.analytics.size());
      geometry_.analytics.push_back({kind, placed, inverse(placed)});
    } else {
      place_mesh(kind.triangulated(), to_group, piece);
      if constexpr (std::is_same_v<Kind, Rectangle>) rectangle = transformed(kind, to_group);
    }
  }

  static Rectangle transformed(const Rectangle& r, const Affine& map) {
    return {Vec3(map.point(Vec3d(r.origin))), Vec3(map.vector(Vec3d(r.edge_u))),
            Vec3(map.vector(Vec3d(r.edge_v)))};
  }

  Geometry& geometry_;
  std::vector<PlacedMesh>& meshes_;
  std::uint32_t group_;
  std::vector<Emitter> emitters_;
};

std::vector<TracedMesh> traced(std::vector<PlacedMesh> meshes) {
  std::vector<TracedMesh> traced(meshes.size());
  parallel_for(meshes.size(), [&](std::size_t i) {
    Mesh mesh = std::move(meshes[i].mesh);  // given back as soon as it is traced
    mesh.transform(meshes[i].to_group);
    traced[i] = TracedMesh(mesh);
  });
  return traced;
}

// Barycentric weights of the three vertices.
Vec3 weights(const Vec2& b) { return {1 - b.x - b.y, b.x, b.y}; }

// Of group space, before an instance moves it.
struct GroupSurface {
  Vec3 p, ng, ns;
  float magnitude = 0;  // of the numbers that p was made from
  float sliver = 0;     // of its Triangle
  Vec2 uv;
};

GroupSurface mesh_surface(const TracedMesh& mesh, const Hit& hit) {
  const Triangle& triangle = mesh.triangles[hit.primitive];
  const glm::uvec3& t = triangle.vertices;
  const Vertex &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
  const Vec3 w = weights(hit.barycentric);
  GroupSurface s;
  s.p = w.x * a.p + w.y * b.p + w.z * c.p;
  s.ng = triangle.n;
  s.sliver = triangle.sliver;
  s.magnitude = triangle.magnitude;
  s.uv = mesh.mapped ? w.x * a.uv + w.y * b.uv + w.z * c.uv : hit.barycentric;
  s.ns = s.ng;
  if (!mesh.smooth) return s;
  const Vec3 n = w.x * a.n + w.y * b.n + w.z * c.n;
  const float facing = dot(n, s.ng);
  if (facing != 0) s.ns = glm::normalize(facing < 0 ? -n : n);
  return s;
}

GroupSurface analytic_surface(const PlacedShape& placed, const Vec3d& p_group) {
  const SurfacePoint point = std::visit(
      [&](const auto& shape) { return shape.nearest(placed.from_group.point(p_group)); }, placed.shape);
  GroupSurface s;
  s.p = Vec3(placed.to_group.point(point.p));
  s.ng = Vec3(glm::normalize(placed.from_group.transposed(point.n)));
  s.ns = s.ng;
  s.magnitude = max_component(glm::abs(s.p));
  s.uv = Vec2(point.uv);
  return s;
}

// An interpolated normal that faces away from a viewer who sees the outer side (or the other way round) would
// leave a black seam at the silhouette: it is turned towards the viewer, to 1° short of level.
Vec3 facing_normal(const Vec3& ns, const Vec3& ng, const Vec3& wo) {
  constexpr float level = 0.0175f;
  const float side = dot(wo, ng) < 0 ? -1.0f : 1.0f;
  const float cosine = side * dot(wo, ns);
  if (cosine > 0) return ns;
  return glm::normalize(ns + side * (level - cosine) * wo);
}

void move_to_world(GroupSurface& s, const Placement& placement) {
  const bool smooth = s.ns != s.ng;
  s.p = Vec3(placement.to_world.point(Vec3d(s.p)));
  const Vec3d ng = placement.from_world.transposed(Vec3d(s.ng));
  const double inverse_length = 1 / glm::length(ng);
  s.ng = Vec3(ng * inverse_length);
  s.sliver *= static_cast<float>(inverse_length);
  s.ns = smooth ? Vec3(glm::normalize(placement.from_world.transposed(Vec3d(s.ns)))) : s.ng;
  s.magnitude = max_component(Vec3(placement.to_world.magnitude(Vec3d(s.magnitude))));
}

// Where a ray met an analytic shape, in the space of its group.
Vec3d group_point(const Ray& ray, const Hit& hit, const Placement* placement) {
  const Vec3d p = Vec3d(ray.o) + static_cast<double>(hit.t) * Vec3d(ray.d);
  return placement ? placement->from_world.point(p) : p;
}

TexturePoint difference(const TexturePoint& a, const TexturePoint& b) {
  TexturePoint result;
  result.uv = a.uv - b.uv;
  result.uv1 = a.uv1 - b.uv1;
  result.p = a.p - b.p;
  result.color = a.color - b.color;
  return result;
}

LocalChart mesh_chart(const TracedMesh& mesh, const Hit& hit, unsigned needs) {
  const auto at = [&](const Vec2& barycentric) {
    return mesh.texture_point(hit.primitive, barycentric, needs);
  };
  const TexturePoint corner = at({0, 0});
  const glm::uvec3& t = mesh.triangles[hit.primitive].vertices;
  const Vec3& p = mesh.vertices[t.x].p;
  return {at(hit.barycentric),
          {mesh.vertices[t.y].p - p, mesh.vertices[t.z].p - p},
          {difference(at({1, 0}), corner), difference(at({0, 1}), corner)},
          mesh.mapped};
}

LocalChart analytic_chart(const PlacedShape& placed, const Vec3d& p_group) {
  const SurfacePoint point = std::visit(
      [&](const auto& shape) { return shape.nearest(placed.from_group.point(p_group)); }, placed.shape);
  LocalChart chart;
  chart.at = TexturePoint(Vec2(point.uv));
  chart.at.uv1 = chart.at.uv;
  chart.at.p = Vec3(placed.to_group.point(point.p));
  for (int i = 0; i < 2; ++i) {
    TexturePoint& d = chart.d[i];
    d.uv[i] = d.uv1[i] = 1;
    chart.dp[i] = d.p = Vec3(placed.to_group.vector(i == 0 ? point.dpdu : point.dpdv));
    d.color = Spectrum(0.0f);
  }
  chart.mapped = true;
  return chart;
}

}  // namespace

Surface Geometry::surface(const Ray& ray, const Hit& hit) const {
  const Piece& piece = this->piece(hit);
  const Placement* placement = hit.instance == no_index ? nullptr : &instances[hit.instance];
  GroupSurface s;
  if (piece.mesh != no_index) {
    s = mesh_surface(meshes[piece.mesh], hit);
  } else {
    s = analytic_surface(analytics[piece.analytic], group_point(ray, hit, placement));
  }
  if (placement) move_to_world(s, *placement);
  if (s.ns != s.ng) s.ns = facing_normal(s.ns, s.ng, -glm::normalize(ray.d));
  Surface surface;
  surface.p = s.p;
  surface.ng = s.ng;
  surface.shading = frame_from_normal(s.ns);
  surface.at.uv = s.uv;
  surface.material = piece.material;
  surface.detail = piece.detail;
  surface.error = surface_error(s.magnitude) + s.sliver;
  if (piece.emitter != no_index)
    surface.light = static_cast<LightId>(piece.emitter + (placement ? placement->first_light : 0));
  return surface;
}

LocalChart Geometry::chart(const Ray& ray, const Hit& hit) const {
  const Piece& piece = this->piece(hit);
  const Placement* placement = hit.instance == no_index ? nullptr : &instances[hit.instance];
  LocalChart chart = piece.mesh != no_index
                         ? mesh_chart(meshes[piece.mesh], hit, piece.needs)
                         : analytic_chart(analytics[piece.analytic], group_point(ray, hit, placement));
  if (placement)
    for (Vec3& dp : chart.dp) dp = Vec3(placement->to_world.vector(Vec3d(dp)));
  return chart;
}

Geometry sorted_geometry(SceneDescription& description) {
  Geometry geometry;
  geometry.groups.resize(1 + description.objects.size());
  std::vector<PlacedMesh> meshes;
  std::vector<std::vector<Emitter>> emitters;
  const auto build = [&](std::vector<Shape>& shapes, std::uint32_t group) {
    GroupBuilder builder(geometry, meshes, group);
    for (Shape& shape : shapes) builder.add(shape);
    emitters.push_back(builder.emitters());
    shapes.clear();
  };
  build(description.shapes, 0);
  for (std::size_t i = 0; i < description.objects.size(); ++i)
    build(description.objects[i].shapes, static_cast<std::uint32_t>(i + 1));
  geometry.meshes = traced(std::move(meshes));

  geometry.emitters = emitters[0];
  for (const Instance& instance : description.instances) {
    const std::uint32_t group = index_of(instance.object) + 1;
    const auto number = static_cast<std::uint32_t>(geometry.instances.size());
    geometry.instances.push_back({group, instance.to_world, inverse(instance.to_world),
                                  static_cast<std::uint32_t>(geometry.emitters.size())});
    for (Emitter emitter : emitters[group]) {
      emitter.instance = number;
      geometry.emitters.push_back(emitter);
    }
  }
  return geometry;
}

}  // namespace umbral
