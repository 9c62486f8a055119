// The textures of a Mitsuba file.
#pragma once

#include <map>

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

  // The attribute of a mesh that the texture is, such as "face_color"; null for other textures.
  const std::string* attribute(TextureId texture) const {
    const auto found = attributes_.find(texture);
    return found == attributes_.end() ? nullptr : &found->second;
  }

  // None if it could not be read, which has been told.
  std::optional<TextureId> texture(const Element& element);

 private:
  std::optional<TextureId> bitmap(const Properties& properties);
  std::optional<TextureId> checkerboard(const Properties& properties);
  std::optional<TextureId> mesh_attribute(const Properties& properties);

  SceneBuilder& builder_;
  const Document& document_;
  std::map<const Element*, std::optional<TextureId>> converted_;
  std::map<TextureId, std::string> attributes_;
};

}  // namespace umbral::mitsuba_file
