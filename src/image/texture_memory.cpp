// OpenImageIO's cache of tiles.
#include "image/texture_memory.h"

#include <algorithm>
#include <vector>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>

#include "core/error.h"
#include "image/texels.h"

namespace umbral {

class TileCache {
 public:
  explicit TileCache(std::size_t bytes) : cache_(made()) {
    cache_->attribute("max_memory_MB", static_cast<float>(bytes) / (1 << 20));
    cache_->attribute("autotile", 64);
    cache_->attribute("unassociatedalpha", 1);
  }

  OIIO::ImageCache& operator*() const { return *cache_; }

 private:
  static std::shared_ptr<OIIO::ImageCache> made() {
#if OIIO_VERSION_MAJOR >= 3
    return OIIO::ImageCache::create(false);
#else
    return {OIIO::ImageCache::create(false),
            [](OIIO::ImageCache* cache) { OIIO::ImageCache::destroy(cache); }};
#endif
  }

  std::shared_ptr<OIIO::ImageCache> cache_;
};

CachedTexels::CachedTexels(std::shared_ptr<TileCache> cache, const std::string& path, bool srgb)
    : cache_(std::move(cache)), path_(path), srgb_(srgb) {
  OIIO::ImageCache& images = **cache_;
  auto* const file = images.get_image_handle(OIIO::ustring(path));
  file_ = file;
  OIIO::ImageSpec spec;
  if (file == nullptr || !images.get_imagespec(file, nullptr, spec))
    throw SceneError({path}, "the image cannot be read: " + images.geterror());
  width_ = spec.width;
  height_ = spec.height;
  channels_ = FileChannels::of(spec.nchannels, spec.alpha_channel);
  bytes_ = spec.format == OIIO::TypeDesc::UINT8;
}

namespace {

OIIO::ImageCache::ImageHandle* handle(void* file) {
  return static_cast<OIIO::ImageCache::ImageHandle*>(file);
}

}  // namespace

// As the loader repairs and decodes them.
Spectrum CachedTexels::decoded(const float* values) const {
  auto [r, g, b, a] = channels_.expanded<float>(values, 1);
  for (float* value : {&r, &g, &b, &a})
    if (!(*value >= 0 && *value < infinity)) *value = 0;
  return srgb_ ? Spectrum(srgb_decode(r), srgb_decode(g), srgb_decode(b), a) : Spectrum(r, g, b, a);
}

Spectrum CachedTexels::at(int x, int y) const {
  OIIO::ImageCache& images = **cache_;
  const int row = height_ - 1 - y;
  const auto read = [&](OIIO::TypeDesc type, void* texel) {
    if (!images.get_pixels(handle(file_), nullptr, 0, 0, x, x + 1, row, row + 1, 0, 1, 0, channels_.count,
                           type, texel))
      throw SceneError({path_}, "the image can no longer be read: " + images.geterror());
  };
  if (bytes_) {
    std::uint8_t texel[4];
    read(OIIO::TypeDesc::UINT8, texel);
    const auto codes = channels_.expanded<std::uint8_t>(texel, 255);
    return srgb_ ? Srgb8::decoded(codes) : Linear8::decoded(codes);
  }
  float texel[4];
  read(OIIO::TypeDesc::FLOAT, texel);
  return decoded(texel);
}

std::pair<Spectrum, Spectrum> CachedTexels::range() const {
  OIIO::ImageCache& images = **cache_;
  std::pair<Spectrum, Spectrum> range{Spectrum(infinity), Spectrum(0.0f)};
  constexpr int rows = 64;
  std::vector<float> values(static_cast<std::size_t>(width_) * rows * channels_.count);
  for (int y = 0; y < height_; y += rows) {
    const int end = std::min(y + rows, height_);
    if (!images.get_pixels(handle(file_), nullptr, 0, 0, 0, width_, y, end, 0, 1, 0, channels_.count,
                           OIIO::TypeDesc::FLOAT, values.data()))
      throw SceneError({path_}, "the image is damaged: " + images.geterror());
    const std::size_t count = static_cast<std::size_t>(width_) * (end - y);
    for (std::size_t i = 0; i < count; ++i) {
      const Spectrum texel = decoded(&values[i * channels_.count]);
      range = {min(range.first, texel), max(range.second, texel)};
    }
  }
  return range;
}

bool TextureMemory::take(std::size_t bytes) {
  const std::size_t whole = bytes_ - bytes_ / 8;
  if (bytes > whole - std::min(whole, taken_)) return false;
  taken_ += bytes;
  return true;
}

const std::shared_ptr<TileCache>& TextureMemory::cache() {
  if (!cache_) cache_ = std::make_shared<TileCache>(std::max<std::size_t>(bytes_ / 8, std::size_t{1} << 20));
  return cache_;
}

}  // namespace umbral
