// Averaging of texels and storing them again.
#include "image/mip_levels.h"

#include <algorithm>

#include "core/parallel.h"

namespace umbral {
namespace {

std::uint8_t code(float x) { return static_cast<std::uint8_t>(glm::clamp(x, 0.0f, 1.0f) * 255 + 0.5f); }

template <class Format>
typename Format::Stored encoded(const Spectrum& value) {
  if constexpr (std::is_same_v<Format, Srgb8>)
    return {code(srgb_encode(value.r)), code(srgb_encode(value.g)), code(srgb_encode(value.b)),
            code(value.a)};
  else if constexpr (std::is_same_v<Format, Linear8>)
    return {code(value.r), code(value.g), code(value.b), code(value.a)};
  else
    return Format::encoded(value);
}

// Which of n texels the `index`-th of m covers, the first and the last of them in part.
struct Cover {
  int first, last;
  float share_of_first, share_of_last, all;  // `all` is the sum of the shares

  Cover(int index, int n, int m) {
    const double from = static_cast<double>(index) * n / m, to = static_cast<double>(index + 1) * n / m;
    first = static_cast<int>(from);
    last = std::min(static_cast<int>(std::ceil(to)), n) - 1;
    share_of_first = static_cast<float>(std::min<double>(first + 1, to) - from);
    share_of_last = first == last ? share_of_first : static_cast<float>(to - last);
    all = static_cast<float>(to - from);
  }
  float share(int i) const { return i == first ? share_of_first : i == last ? share_of_last : 1.0f; }
};

template <class Format>
TexelGrid<Format> half_size(const TexelGrid<Format>& grid) {
  const int width = std::max(1, grid.width() / 2), height = std::max(1, grid.height() / 2);
  TexelGrid<Format> half(width, height);
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    const Cover rows(y, grid.height(), height);
    for (int x = 0; x < width; ++x) {
      const Cover columns(x, grid.width(), width);
      Spectrum sum(0.0f);
      for (int j = rows.first; j <= rows.last; ++j)
        for (int i = columns.first; i <= columns.last; ++i)
          sum += grid.at(i, j) * (rows.share(j) * columns.share(i));
      half.set(x, y, encoded<Format>(sum / (rows.all * columns.all)));
    }
  });
  return half;
}

}  // namespace

std::vector<TextureImage::Texels> mip_levels(const TextureImage::Texels& finest) {
  std::vector<TextureImage::Texels> levels;
  std::visit(
      [&](const auto& grid) {
        using Grid = std::decay_t<decltype(grid)>;
        if constexpr (!std::is_same_v<Grid, CachedTexels>) {
          const Grid* above = &grid;
          while (above->width() > 1 || above->height() > 1) {
            levels.push_back(half_size(*above));
            above = &std::get<Grid>(levels.back());
          }
        }
      },
      finest);
  return levels;
}

}  // namespace umbral
