// Box sums over pixels.
#include "image/pooled_error.h"

#include "core/parallel.h"

namespace umbral {

std::vector<Vec3d> pooled_errors(const FilmImage& image) {
  constexpr int reach = 2;  // pixels to each side
  const FilmLayout& layout = image.layout;
  std::vector<Vec3d> pooled(image.pixels.size(), Vec3d(infinity));
  parallel_for(static_cast<std::size_t>(layout.crop_height()), [&](std::size_t row) {
    const int y = layout.y0 + static_cast<int>(row);
    for (int x = layout.x0; x < layout.x1; ++x) {
      Vec3d squares(0);
      double count = 0;
      for (int j = std::max(layout.y0, y - reach); j < std::min(layout.y1, y + reach + 1); ++j)
        for (int i = std::max(layout.x0, x - reach); i < std::min(layout.x1, x + reach + 1); ++i) {
          const PixelEstimate& pixel = image.at(i, j);
          if (pixel.samples == 0 || !std::isfinite(pixel.standard_error.x)) continue;
          squares += sqr(pixel.standard_error);
          ++count;
        }
      if (count > 0) pooled[layout.index(x, y)] = sqrt(squares / count);
    }
  });
  return pooled;
}

}  // namespace umbral
