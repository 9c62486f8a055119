// Textures of MTL files.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/assembly/scene_builder.h"
#include "formats/obj/mtl_reader.h"

namespace umbral {

// What is to be told of a material, together.
using Notes = std::vector<std::string>;

struct MtlTextureUse {
  const char* key;  // "map_Kd"
  float factor = 1;
  ColorSpace space = ColorSpace::automatic;
  TextureChannel channel = TextureChannel::luminance;
  Range range = zero_to_one;  // what its values must keep
};

// The channel that a map chooses for a single number.
TextureChannel channel_of(const MtlMap& map);

// Bluish on the whole: some programs write normal maps as bumps.
bool looks_like_normals(const TextureImage& image);

// Reads images of MTL files and makes textures from them.
class MtlTextures {
 public:
  // `only_expects`: image() gives none, and has the builder expect it instead.
  MtlTextures(SceneBuilder& builder, const std::filesystem::path& folder, Notes& notes, bool only_expects)
      : builder_(builder), folder_(folder), notes_(notes), only_expects_(only_expects) {}

  // The image of the map; null where it cannot be read, which is told once. Paths with backslashes and paths
  // that only existed elsewhere are looked for by their last part.
  std::shared_ptr<const TextureImage> image(const MtlMap& map, ColorSpace space);

  // A texture of that image. A value that leaves the range is told as an error: then none.
  std::optional<TextureId> texture(const MtlMap& map, std::shared_ptr<const TextureImage> image,
                                   const MtlTextureUse& use);

 private:
  std::filesystem::path found(const MtlMap& map);

  SceneBuilder& builder_;
  const std::filesystem::path& folder_;
  Notes& notes_;
  bool only_expects_;
  std::map<const MtlMap*, std::shared_ptr<const TextureImage>> images_;
};

}  // namespace umbral
