// TextureTable: the textures of a glTF file as textures of a scene.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "formats/assembly/scene_builder.h"
#include "formats/gltf/document.h"
#include "formats/gltf/report.h"

namespace umbral::gltf {

// How a material looks at a texture.
struct TextureUse {
  ColorSpace space = ColorSpace::linear;
  TextureChannel channel = TextureChannel::luminance;
  float factor = 1, bias = 0;  // value = texel × factor + bias
};

class TextureTable {
 public:
  TextureTable(const Document& document, SceneBuilder& builder, std::filesystem::path folder, Report& report)
      : document_(document), builder_(builder), folder_(std::move(folder)), report_(report) {}

  // Has the image of a texture decoded when the builder's `images_ahead` are; the table must live until then.
  void expect(const TextureInfo& info, ColorSpace space);

  // A texture of the scene; `path` is that of the texture info. None where its image cannot be read, which is told.
  std::optional<TextureId> texture(const TextureInfo& info, const TextureUse& use, const std::string& path);

 private:
  std::shared_ptr<const TextureImage> image(Ref<List::images> ref, ColorSpace space);
  std::optional<std::filesystem::path> file_of(Ref<List::images> ref) const;
  std::string name_of(Ref<List::images> ref, const std::string& mime_type) const;
  DecodedImage decoded(Ref<List::images> ref, ColorSpace space) const;
  Ref<List::images> source_of(const TextureData& texture) const;

  const Document& document_;
  SceneBuilder& builder_;
  std::filesystem::path folder_;
  Report& report_;
  std::map<std::pair<std::uint32_t, ColorSpace>, std::shared_ptr<const TextureImage>> images_;
};

}  // namespace umbral::gltf
