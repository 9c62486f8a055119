// The textures of a Mitsuba file.
#pragma once

#include <map>
#include <set>

#include "formats/mitsuba/properties.h"

namespace umbral::mitsuba_file {

// umbral's uv is Mitsuba's own: v of an image runs from its upper edge down, so images are turned over here.
class Textures {
 public:
  Textures(SceneBuilder& builder, const Document& document) : builder_(builder), document_(document) {}

  // A property that is a colour or a texture.
  Textured<Spectrum> surface(const Properties& properties, const std::string& name,
                             const Spectrum& otherwise);
  Textured<float> number(const Properties& properties, const std::string& name, float otherwise);
  // What an emitter gives.
  Textured<Spectrum> light(const Properties& properties, const std::string& name, const Spectrum& otherwise);

  // Whether the texture is the colours of a mesh's faces.
  bool is_of_faces(TextureId texture) const { return of_faces_.contains(texture); }

  // None if it could not be read, which has been told.
  std::optional<TextureId> texture(const Element& element);

 private:
  std::optional<TextureId> bitmap(const Properties& properties);
  std::optional<TextureId> checkerboard(const Properties& properties);
  std::optional<TextureId> mesh_attribute(const Properties& properties);

  SceneBuilder& builder_;
  const Document& document_;
  std::map<const Element*, std::optional<TextureId>> converted_;
  std::set<TextureId> of_faces_;
};

}  // namespace umbral::mitsuba_file
