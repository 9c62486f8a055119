// The shapes of a pbrt file.
#pragma once

#include <filesystem>

#include "formats/pbrt/lights.h"
#include "formats/pbrt/materials.h"

namespace umbral::pbrt_file {

// What stands around a Shape directive.
struct Surroundings {
  Affine to_world;
  bool reversed = false;
  MaterialHandle material;
  AreaLight light;
  std::shared_ptr<const Medium> inside;
};

class Shapes {
 public:
  Shapes(SceneBuilder& builder, std::filesystem::path folder, Materials& materials, Textures& textures)
      : builder_(builder), folder_(std::move(folder)), materials_(materials), textures_(textures) {}

  void add(const std::string& kind, const Parameters& parameters, const Surroundings& around,
           ShapeList& shapes);

 private:
  std::optional<ShapeKinds> read(const std::string& kind, const Parameters& parameters);
  std::optional<ShapeKinds> sphere(const Parameters& parameters);
  std::optional<ShapeKinds> disk(const Parameters& parameters);
  std::optional<ShapeKinds> cylinder(const Parameters& parameters);
  std::optional<ShapeKinds> triangle_mesh(const Parameters& parameters);
  std::optional<ShapeKinds> ply_mesh(const Parameters& parameters);
  std::optional<ShapeKinds> bilinear_mesh(const Parameters& parameters);
  std::optional<ShapeKinds> subdivided(const Parameters& parameters);
  std::vector<std::uint32_t> indices(const Parameters& parameters, std::size_t vertices, std::size_t arity);
  double radius(const Parameters& parameters);
  void full_turn(const Parameters& parameters);
  void reverse(Shape& shape, const Parameters& parameters, const AreaLight& light);
  void place(Shape shape, const Parameters& parameters, const AreaLight& light, ShapeList& shapes);
  void place_by_triangles(Shape shape, const Parameters& parameters, const AreaLight& light,
                          ShapeList& shapes);
  void shine(Shape& shape, const Parameters& parameters, const AreaLight& light);

  SceneBuilder& builder_;
  std::filesystem::path folder_;
  Materials& materials_;
  Textures& textures_;
};

}  // namespace umbral::pbrt_file
