// Scenes made in code: the parts of a SceneDescription in one line each.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace umbral::test {

inline CameraSettings camera(const Vec3& position, const Vec3& look_at, float fov,
                             const Vec3& up = {0, 0, 1}) {
  CameraSettings settings;
  settings.position = position;
  settings.look_at = look_at;
  settings.up = up;
  settings.fov = fov;
  return settings;
}

// A lobe with some of its parameters, named as in a scene file, taken from textures.
inline MaterialId add_material(SceneDescription& scene, const Lobes& lobe,
                               const std::vector<std::pair<std::string, TextureId>>& maps = {}) {
  Material material;
  material.lobe = lobe;
  for_each_material_parameter(material, [&](const ParameterInfo& info, auto& value) {
    if constexpr (requires { value.map; })
      for (const auto& [name, texture] : maps)
        if (name == info.name) value.map = texture;
  });
  scene.materials.push_back(material);
  return static_cast<MaterialId>(scene.materials.size() - 1);
}

inline MaterialId add_matte(SceneDescription& scene, const Spectrum& reflectance) {
  return add_material(scene, Lambert{reflectance});
}
inline MaterialId add_matte(SceneDescription& scene, TextureId reflectance) {
  return add_material(scene, Lambert{}, {{"reflectance", reflectance}});
}

inline TextureId add_texture(SceneDescription& scene, TextureKinds kind) {
  Texture texture{"", std::move(kind)};
  texture.prepare(scene.textures);
  scene.textures.push_back(std::move(texture));
  return static_cast<TextureId>(scene.textures.size() - 1);
}

// The shape, to be given its place and emission by the caller.
inline Shape& add_shape(SceneDescription& scene, ShapeKinds kind, MaterialId material,
                        const Spectrum& emission = black) {
  Shape shape;
  shape.kind = std::move(kind);
  shape.material = material;
  shape.emission.value = emission;
  scene.shapes.push_back(std::move(shape));
  return scene.shapes.back();
}

inline Sphere sphere(const Vec3& center, float radius) {
  Sphere result;
  result.center = center;
  result.radius = radius;
  return result;
}

inline Rectangle rectangle(const Vec3& origin, const Vec3& edge_u, const Vec3& edge_v) {
  return {origin, edge_u, edge_v};
}

inline Disk disk(const Vec3& center, const Vec3& normal, float radius) { return {center, normal, radius}; }

inline Torus torus(float major_radius, float minor_radius) { return {major_radius, minor_radius}; }

inline Box box(const Vec3& low, const Vec3& high) { return {low, high}; }

// A fan of triangles around the first vertex, counter-clockwise.
inline Mesh polygon(const std::vector<Vec3>& vertices) {
  Mesh mesh;
  mesh.positions = vertices;
  for (std::uint32_t i = 2; i < vertices.size(); ++i) mesh.triangles.push_back({0, i - 1, i});
  return mesh;
}

// Texels that both the program and an oracle can look up; row 0 is at v = 0.
class TestImage {
 public:
  // Each texel in `low` … `high`, by a hash of its place and `seed`.
  TestImage(int width, int height, double low, double high, std::uint64_t seed);
  // From a function of the texel's middle (u, v).
  template <class Function>
  TestImage(int width, int height, const Function& value) : width_(width), height_(height) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        texels_.push_back(Vec3d(Vec3(value((x + 0.5) / width, (y + 0.5) / height))));
  }

  int width() const { return width_; }
  int height() const { return height_; }
  Vec3d& texel(int x, int y) { return texels_[static_cast<std::size_t>(y) * width_ + x]; }
  const Vec3d& texel(int x, int y) const { return texels_[static_cast<std::size_t>(y) * width_ + x]; }

  // Bilinear and repeated, in double.
  Vec3d at(double u, double v) const;
  std::shared_ptr<const TextureImage> texture_image() const;
  ImageTexture texture() const;  // bilinear, repeated

 private:
  int width_, height_;
  std::vector<Vec3d> texels_;
};

}  // namespace umbral::test
