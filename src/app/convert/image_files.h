// ImageFiles: where the images of a converted scene are.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "scene/textures/image_texture.h"

namespace umbral {

class ImageFiles {
 public:
  /// Scene files are written into `folder`, images that are no files into `assets` below it; names that images have are
  /// relative to `source`, or as they stand.
  ImageFiles(std::filesystem::path folder, std::filesystem::path assets, std::filesystem::path source)
      : folder_(std::move(folder)), assets_(std::move(assets)), source_(std::move(source)) {}

  struct Place {
    std::string file;  // relative to the scene file
    ColorSpace color_space;
  };

  /// Of an image that was called `name` and read in that space, if it came from a file. Throws OutputError.
  Place place_of(const std::shared_ptr<const TextureImage>& image, const std::string& name, ColorSpace space);
  /// The same of the tiles of a name with <UDIM>.
  Place place_of(const UdimTiles& tiles, const std::string& name, ColorSpace space);

 private:
  bool is_that(const std::filesystem::path& file, ColorSpace space, const TextureImage& image) const;
  std::string relative(const std::filesystem::path& file) const;

  std::filesystem::path folder_, assets_, source_;
  std::map<const TextureImage*, Place> places_;
  std::map<const UdimTiles*, Place> tile_places_;
};

}  // namespace umbral
