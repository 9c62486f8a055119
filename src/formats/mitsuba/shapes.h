// The shapes of a Mitsuba file.
#pragma once

#include "formats/meshes/mesh_file.h"
#include "formats/mitsuba/materials.h"

namespace umbral::mitsuba_file {

class Shapes {
 public:
  Shapes(SceneBuilder& builder, const Document& document, Materials& materials, Textures& textures)
      : builder_(builder), document_(document), materials_(materials), textures_(textures) {}

  // A shape of the world, a group of shapes, or an instance of one.
  void add(const Element& element) { add(element, builder_.world); }

 private:
  void add(const Element& element, ShapeList& shapes);
  void add_group(const Properties& properties);
  void add_instance(const Properties& properties);
  Textured<Spectrum> emission(const Element& emitter);
  // The attribute of its mesh that what is seen of a shape asks for; empty where there is none. Two are told.
  std::string attribute_of(MaterialId material, const Textured<Spectrum>& emission, const Place& place);
  std::optional<ShapeKinds> read(const Properties& properties, const std::string& attribute,
                                 Affine& to_world);
  std::optional<ShapeKinds> sphere(const Properties& properties, Affine& to_world);
  std::optional<ShapeKinds> cylinder(const Properties& properties);
  std::optional<Mesh> mesh_from_file(const Properties& properties, const std::string& attribute);
  std::optional<Mesh> serialized(const Properties& properties);
  void turn_over(Shape& shape, const Place& place);

  SceneBuilder& builder_;
  const Document& document_;
  Materials& materials_;
  Textures& textures_;
  std::map<const Element*, ObjectId> groups_;
};

}  // namespace umbral::mitsuba_file
