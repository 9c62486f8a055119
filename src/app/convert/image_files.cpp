// Images of a converted scene: found again on disk, or written.
#include "app/convert/image_files.h"

#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "image/exr.h"

namespace umbral {
namespace {

// Linear floats hold the texels of every kind of image to the bit.
void write_texels(const std::string& path, const TextureImage& image) {
  ExrImage exr;
  exr.width = exr.x1 = image.width();
  exr.height = exr.y1 = image.height();
  for (const char* name : {"R", "G", "B", "A"}) exr.channels.push_back({name, {}});
  for (int y = image.height() - 1; y >= 0; --y)
    for (int x = 0; x < image.width(); ++x) {
      const Spectrum texel = image.texel(x, y);
      for (int c = 0; c < 4; ++c) exr.channels[static_cast<std::size_t>(c)].pixels.push_back(texel[c]);
    }
  write_exr(path, exr);
}

}  // namespace

bool ImageFiles::is_that(const std::filesystem::path& file, ColorSpace space,
                         const TextureImage& image) const {
  std::error_code absent;
  if (!std::filesystem::is_regular_file(file, absent)) return false;
  try {
    std::vector<std::string> repairs;
    const TextureImage read = load_texture_image(file.string(), space, repairs);
    if (read.width() != image.width() || read.height() != image.height()) return false;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (read.texel(x, y) != image.texel(x, y)) return false;
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

std::string ImageFiles::relative(const std::filesystem::path& file) const {
  // Neither nothing nor a name with <UDIM>, which no file has, is made absolute by relative() itself.
  const std::filesystem::path from = std::filesystem::current_path() / folder_;
  return std::filesystem::relative(std::filesystem::absolute(file), from).generic_string();
}

ImageFiles::Place ImageFiles::place_of(const std::shared_ptr<const TextureImage>& image,
                                       const std::string& name, ColorSpace space) {
  const auto known = places_.find(image.get());
  if (known != places_.end()) return known->second;
  if (!name.empty())
    for (const std::filesystem::path& candidate : {source_ / name, std::filesystem::path(name)})
      if (is_that(candidate, space, *image))
        return places_.emplace(image.get(), Place{relative(candidate), space}).first->second;
  std::filesystem::create_directories(folder_ / assets_);
  const std::filesystem::path file = assets_ / fmt::format("image-{}.exr", places_.size());
  write_texels((folder_ / file).string(), *image);
  return places_.emplace(image.get(), Place{file.generic_string(), ColorSpace::linear}).first->second;
}

ImageFiles::Place ImageFiles::place_of(const UdimTiles& tiles, const std::string& name, ColorSpace space) {
  const auto known = tile_places_.find(&tiles);
  if (known != tile_places_.end()) return known->second;
  const auto each = [&](const std::filesystem::path& file, auto&& visit) {
    bool all = true;
    for (std::size_t i = 0; i < tiles.images.size() && all; ++i)
      if (tiles.images[i])
        all = visit(UdimTiles::file_of(file.string(), UdimTiles::first + static_cast<int>(i)),
                    *tiles.images[i]);
    return all;
  };
  for (const std::filesystem::path& candidate : {source_ / name, std::filesystem::path(name)})
    if (each(candidate,
             [&](const std::string& file, const TextureImage& tile) { return is_that(file, space, tile); }))
      return tile_places_.emplace(&tiles, Place{relative(candidate), space}).first->second;
  std::filesystem::create_directories(folder_ / assets_);
  const std::filesystem::path file = assets_ / fmt::format("tiles-{}.<UDIM>.exr", tile_places_.size());
  each(folder_ / file, [](const std::string& path, const TextureImage& tile) {
    write_texels(path, tile);
    return true;
  });
  return tile_places_.emplace(&tiles, Place{file.generic_string(), ColorSpace::linear}).first->second;
}

}  // namespace umbral
