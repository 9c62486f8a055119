// TextureMemory: how many bytes the texels of a scene may take; what does not fit is read piece by piece.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "core/spectrum.h"
#include "image/file_channels.h"

namespace umbral {

inline constexpr std::size_t default_texture_memory = std::size_t{4} << 30;

class TileCache;

// An image that stays in its file: OpenImageIO's cache reads the tiles that are looked at and forgets those that were
// not for long. Tiled files (TIFF, EXR) suit it; others it has to read from their beginning. Same texels as TexelGrid.
class CachedTexels {
 public:
  // Throws SceneError where the file cannot be read.
  CachedTexels(std::shared_ptr<TileCache> cache, const std::string& path, bool srgb);

  int width() const { return width_; }
  int height() const { return height_; }
  Spectrum at(int x, int y) const;  // throws SceneError if the file can no longer be read
  std::size_t memory() const { return 0; }
  bool is_srgb() const { return srgb_; }
  // The smallest and the largest value of each channel; reads the whole file.
  std::pair<Spectrum, Spectrum> range() const;

 private:
  Spectrum decoded(const float* values) const;

  std::shared_ptr<TileCache> cache_;
  void* file_;  // OpenImageIO's handle, which lives as long as the cache
  std::string path_;
  int width_ = 0, height_ = 0;
  FileChannels channels_{};
  bool srgb_, bytes_ = false;
};

class TextureMemory {
 public:
  // Seven eighths for images as a whole, the rest for the cache.
  explicit TextureMemory(std::size_t bytes = default_texture_memory) : bytes_(bytes) {}

  // Whether so many bytes are left for an image or its levels; then they are taken.
  bool take(std::size_t bytes);

  // Made when it is first asked for.
  const std::shared_ptr<TileCache>& cache();
  std::size_t taken() const { return taken_; }

 private:
  std::size_t bytes_, taken_ = 0;
  std::shared_ptr<TileCache> cache_;
};

}  // namespace umbral
