// How the channels of an image file make up red, green, blue and alpha.
#pragma once

#include <array>

namespace umbral {

struct FileChannels {
  int count;       // of those read, from the first
  bool grey;       // r = g = b
  int alpha = -1;  // which of them; −1 if none

  // `channels` in the file, of which `alpha_channel` is alpha; −1 for none.
  static FileChannels of(int channels, int alpha_channel) {
    if (channels == 1) return {1, true, -1};
    if (channels == 2) return {2, alpha_channel == 1, alpha_channel == 1 ? 1 : -1};
    if (channels >= 4 && alpha_channel == 3) return {4, false, 3};
    return {3, false, -1};
  }

  // One texel of the file, as red, green, blue and alpha; `one` stands for 1.
  template <class T>
  std::array<T, 4> expanded(const T* texel, T one) const {
    std::array<T, 4> rgba{texel[0], texel[0], texel[0], one};
    if (!grey) {
      rgba[1] = texel[1];
      rgba[2] = count > 2 ? texel[2] : T{0};
    }
    if (alpha >= 0) rgba[3] = texel[alpha];
    return rgba;
  }
};

}  // namespace umbral
