// MaterialMaps: factors times textures times vertex colours, as the parameters of a glTF material are written.
#pragma once

#include <functional>

#include "formats/gltf/texture_table.h"
#include "scene/ids.h"

namespace umbral::gltf {

class MaterialMaps {
 public:
  // Makes a texture of the scene, or none.
  using MakeTexture = std::function<std::optional<TextureId>(const TextureInfo& info, const TextureUse& use)>;

  // `vertex_colors`: the mesh has colours, which multiply what is painted.
  MaterialMaps(SceneBuilder& builder, bool vertex_colors, MakeTexture make_texture)
      : builder_(builder), vertex_colors_(vertex_colors), make_texture_(std::move(make_texture)) {}

  // factor × texture (sRGB).
  Textured<Spectrum> color(const Rgb& factor, const TextureSlot& slot);
  // The same, times the colour of the vertices; and its opacity.
  Textured<Spectrum> painted(const Rgb& factor, const TextureSlot& slot);
  Textured<float> painted_alpha(double factor, const TextureSlot& slot);
  // factor × one channel of a texture (linear) + bias.
  Textured<float> number(double factor, const TextureSlot& slot, TextureChannel channel, double bias = 0);
  // The angles of the directions in red and green, plus so many degrees.
  std::optional<TextureId> directions(const TextureInfo& info, float rotation);
  std::optional<TextureId> image(const TextureInfo& info, const TextureUse& use) {
    return make_texture_(info, use);
  }

 private:
  TextureId product(TextureId texture, const Textured<Spectrum>& scale);
  TextureId vertex_color(TextureChannel channel);

  SceneBuilder& builder_;
  bool vertex_colors_;
  MakeTexture make_texture_;
};

}  // namespace umbral::gltf
