// Rows first, then columns, a row of the result at a time, so that both inner loops run over neighbours in memory.
#include "analysis/convolution.h"

#include <algorithm>

#include "core/parallel.h"

namespace umbral {
namespace {

void add_multiple(float* sum, const float* values, float weight, int count) {
  for (int i = 0; i < count; ++i) sum[i] += weight * values[i];
}

void filter_row(const float* in, int width, const Kernel& kernel, std::vector<float>& padded, float* out) {
  const int radius = static_cast<int>(kernel.size() / 2);
  std::fill(padded.begin(), padded.begin() + radius, in[0]);
  std::copy(in, in + width, padded.begin() + radius);
  std::fill(padded.begin() + radius + width, padded.end(), in[width - 1]);
  std::fill(out, out + width, 0.0f);
  for (std::size_t k = 0; k < kernel.size(); ++k)
    if (kernel[k] != 0) add_multiple(out, padded.data() + k, kernel[k], width);
}

void filter_columns(const Plane& in, const Kernel& kernel, int y, float* sum) {
  int row = y - static_cast<int>(kernel.size() / 2);
  for (const float weight : kernel) {
    if (weight != 0) add_multiple(sum, in.row(std::clamp(row, 0, in.height - 1)), weight, in.width);
    ++row;
  }
}

// Blocks of rows, so that a thread's scratch is made once a block and its rows stay in the cache.
constexpr int block = 32;

std::size_t blocks(const Plane& plane) {
  return static_cast<std::size_t>((plane.height + block - 1) / block);
}

}  // namespace

Plane filtered(const Plane& in, const std::vector<SeparableTerm>& terms) {
  Plane out(in.width, in.height), half(in.width, in.height);
  for (const SeparableTerm& term : terms) {
    parallel_for(blocks(in), [&](std::size_t b) {
      std::vector<float> padded(static_cast<std::size_t>(in.width) + term.across.size() - 1);
      const int first = static_cast<int>(b) * block;
      for (int y = first; y < std::min(first + block, in.height); ++y)
        filter_row(in.row(y), in.width, term.across, padded, half.row(y));
    });
    parallel_for(blocks(in), [&](std::size_t b) {
      const int first = static_cast<int>(b) * block;
      for (int y = first; y < std::min(first + block, in.height); ++y)
        filter_columns(half, term.down, y, out.row(y));
    });
  }
  return out;
}

}  // namespace umbral
