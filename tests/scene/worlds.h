// Small worlds for the tests of scenes: closed meshes, and one shape alone in the world or in an instance.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "affine_examples.h"
#include "support/scene_kit.h"

namespace umbral::test {

/// The unit sphere as an icosahedron whose triangles are cut in four `levels` times, with shared vertices and
/// counter-clockwise from outside; vertex normals where asked for.
inline Mesh icosphere(int levels, bool with_normals = false) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3d> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                            {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<glm::uvec3> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Vec3d& p : points) p = glm::normalize(p);
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<unsigned>(points.size()));
      if (is_new) points.push_back(glm::normalize(points[a] + points[b]));
      return found->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : triangles) {
      const unsigned a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
      finer.insert(finer.end(), {{t.x, a, c}, {t.y, b, a}, {t.z, c, b}, {a, b, c}});
    }
    triangles = std::move(finer);
  }
  Mesh mesh;
  mesh.triangles = std::move(triangles);
  for (const Vec3d& p : points) mesh.positions.emplace_back(p);
  if (with_normals)
    for (const Vec3d& p : points) mesh.normals.emplace_back(p);
  return mesh;
}

/// The same surface of triangles that share no vertices and begin at another corner each, among which are others without
/// area: along edges, and points.
inline Mesh loosened(const Mesh& mesh) {
  Mesh loose;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<unsigned>(loose.positions.size());
    loose.positions.insert(loose.positions.end(), {a, b, c});
    loose.triangles.push_back({first, first + 1, first + 2});
  };
  for (unsigned i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const Vec3 &a = mesh.positions[t[i % 3]], &b = mesh.positions[t[(i + 1) % 3]],
               &c = mesh.positions[t[(i + 2) % 3]];
    add(a, b, c);
    if (i % 5 == 0) add(a, b, a);
    if (i % 5 == 1) add(c, c, c);
    if (i % 5 == 2) add(a, b, (a + b) * 0.5f);
  }
  return loose;
}

/// The shape moved by `to_world`, as a shape of the world or as the only one of an instanced object.
inline SceneDescription world_of(ShapeKinds kind, const Affine& to_world, bool instanced,
                                 const Spectrum& emission = black) {
  SceneDescription scene;
  add_matte(scene, grey(0.5f));
  Shape shape;
  shape.kind = std::move(kind);
  shape.material = static_cast<MaterialId>(0);
  shape.emission.value = emission;
  if (instanced) {
    scene.objects.push_back({"", {std::move(shape)}});
    scene.instances.push_back({static_cast<ObjectId>(0), to_world});
  } else {
    shape.to_world = to_world;
    scene.shapes.push_back(std::move(shape));
  }
  return scene;
}

/// The surface that the ray meets first.
inline std::optional<Surface> seen(const Scene& scene, const Ray& ray) {
  const std::optional<Hit> hit = scene.intersect(ray);
  if (!hit) return std::nullopt;
  return scene.surface(ray, *hit);
}

}  // namespace umbral::test
