// The smallest images of the kinds that textures come in.
#pragma once

#include <string>
#include <string_view>

#include "formats/scene_folder.h"

namespace umbral::test {

inline std::string bytes_of_hex(std::string_view digits) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(16 * value(digits[i]) + value(digits[i + 1]));
  return bytes;
}

// 2 × 1 texels, grey.
inline std::string pfm() {
  const float texels[] = {0.25f, 1};
  return "Pf\n2 1\n-1\n" + std::string(reinterpret_cast<const char*>(texels), sizeof texels);
}

// 2 × 1 texels of shared exponent.
inline std::string hdr() {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y 1 +X 2\n" + bytes_of_hex("8040207f80808082");
}

// 3 × 2 texels, RGB, packed by zlib with the filter of differences.
inline std::string png() {
  return bytes_of_hex(
      "89504e470d0a1a0a0000000d49484452000000030000000208020000001216f14d0000001c4944415478da6364b0a9d0485910"
      "d073"
      "8291cbadc9286f55d4b44b003fd407651b3f5c990000000049454e44ae426082");
}

// 8 × 8 texels: a grey that grows from row to row.
inline std::string jpeg() {
  return bytes_of_hex(
      "ffd8ffe000104a46494600010100000100010000ffdb004300281c1e231e19282321232d2b28303c64413c37373c7b585d4964"
      "9180"
      "99968f808c8aa0b4e6c3a0aadaad8a8cc8ffcbdaeef5ffffff9bc1fffffffaffe6fdfff8ffc0000b080008000801011100ffc4"
      "0014"
      "000100000000000000000000000000000000ffc400161000030000000000000000000000000000001461ffda0008010100003f"
      "0025"
      "0fffd9");
}

}  // namespace umbral::test
