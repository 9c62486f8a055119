// Images in memory, for the program and for oracles.
#include "support/scene_kit.h"

#include "core/hash.h"

namespace umbral::test {

TestImage::TestImage(int width, int height, double low, double high, std::uint64_t seed)
    : width_(width), height_(height) {
  const auto texels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  for (std::uint64_t i = 0; i < texels; ++i) {
    Vec3 texel;
    for (int c = 0; c < 3; ++c) {
      const std::uint64_t hash = hash_combine(seed, 3 * i + static_cast<std::uint64_t>(c));
      texel[c] = static_cast<float>(low + (high - low) * unit_float(static_cast<std::uint32_t>(hash)));
    }
    texels_.push_back(Vec3d(texel));
  }
}

Vec3d TestImage::at(double u, double v) const {
  const double x = u * width_ - 0.5, y = v * height_ - 0.5;
  const auto column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const double fx = x - column, fy = y - row;
  const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
  const auto value = [&](int i, int j) {
    return texel(wrapped(column + i, width_), wrapped(row + j, height_));
  };
  return (1 - fy) * ((1 - fx) * value(0, 0) + fx * value(1, 0)) +
         fy * ((1 - fx) * value(0, 1) + fx * value(1, 1));
}

std::shared_ptr<const TextureImage> TestImage::texture_image() const {
  TexelGrid<Float4> grid(width_, height_);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) grid.set(x, y, Spectrum(Vec3(texel(x, y)), 1));
  return std::make_shared<TextureImage>(TextureImage::Texels(std::move(grid)));
}

ImageTexture TestImage::texture() const {
  ImageTexture texture;
  texture.image = texture_image();
  return texture;
}

}  // namespace umbral::test
