// The named textures of a pbrt file.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "formats/pbrt/parameters.h"

namespace umbral::pbrt_file {

// What an image map's "encoding" says; automatic where that is neither "linear" nor "sRGB".
ColorSpace color_space_of(const std::string& encoding);

class Textures {
 public:
  Textures(SceneBuilder& builder, std::filesystem::path folder)
      : builder_(builder), folder_(std::move(folder)) {}

  // Converted when something asks for it. `to_world`: of the space that it may be laid through.
  void define(const Place& place, const std::string& name, bool is_float, const std::string& kind,
              Parameters parameters, const Affine& to_world);

  // A parameter that may name a texture; of the given value where it is absent.
  Textured<Spectrum> spectrum(const Parameters& parameters, const std::string& name,
                              const Spectrum& otherwise);
  Textured<float> number(const Parameters& parameters, const std::string& name, float otherwise);
  // The image in that file; none if it cannot be read, which is told.
  std::optional<TextureId> normal_map(const Parameter& file);
  // Of one that is laid through the world; none where there is none.
  const std::optional<Place>& laid_through_space() const { return laid_; }

 private:
  struct Definition {
    std::string kind;
    Parameters parameters;
    Affine to_world;
    bool is_converting = false;
    std::optional<Textured<Spectrum>> converted = {};
  };

  Textured<Spectrum> find(const Parameter& parameter, bool is_float);
  Textured<Spectrum> convert(const std::string& name, Definition& definition, bool is_float);
  Textured<Spectrum> value(const Parameters& parameters, const std::string& name, const Spectrum& otherwise,
                           bool is_float);
  Textured<Spectrum> image(const std::string& name, const Definition& definition);
  Textured<Spectrum> checker(const std::string& name, const Definition& definition, bool is_float);
  Textured<Spectrum> scaled(const std::string& name, const Parameters& parameters, bool is_float);
  Textured<Spectrum> mixed(const std::string& name, const Parameters& parameters, bool is_float);
  std::optional<TextureId> with_image(const std::string& name, ImageTexture texture, const Parameter& file);
  // The texture's placement in uv, or what lays it through space, in which its own name is still to be filled in.
  template <class Map>
  std::optional<ProjectedTexture> read_mapping(const Definition& definition, Map& texture);
  Textured<Spectrum> laid(TextureId texture, std::optional<ProjectedTexture> projection);

  SceneBuilder& builder_;
  std::filesystem::path folder_;
  std::map<std::string, Definition> definitions_[2];  // of spectra, of floats
  std::optional<Place> laid_;
};

}  // namespace umbral::pbrt_file
