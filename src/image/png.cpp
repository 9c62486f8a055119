// Tone mapping, and PNG by OpenImageIO.
#include "image/png.h"

#include <cassert>
#include <cstdint>
#include <memory>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"
#include "image/atomic_file.h"

namespace umbral {
namespace {

Spectrum limited(const Spectrum& c, ToneMap tone_map) {
  const float largest = max_component(c);
  switch (tone_map) {
    case ToneMap::hue:
      return c / std::max(1.0f, largest);
    case ToneMap::clip:
      return min(c, Spectrum(1.0f));
    case ToneMap::reinhard:
      return c / (1 + largest);
  }
  return c;
}

std::vector<std::uint8_t> encoded(std::span<const Spectrum> linear, float exposure_stops, ToneMap tone_map) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * linear.size());
  for (const Spectrum& pixel : linear) {
    const Spectrum shown = display_colour(pixel, exposure_stops, tone_map);
    for (int c = 0; c < 3; ++c) bytes.push_back(static_cast<std::uint8_t>(255 * shown[c] + 0.5f));
  }
  return bytes;
}

// The bytes of a PNG file. They are made in memory, so that one writer knows all about failing disks.
std::vector<unsigned char> compressed(const std::string& path, int width, int height,
                                      const std::vector<std::uint8_t>& rgb) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png", &memory);
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  const bool done = output && output->open("png", spec) &&
                    output->write_image(OIIO::TypeDesc::UINT8, rgb.data()) && output->close();
  if (!done)
    throw OutputError(
        fmt::format("cannot write '{}': {}", path, output ? output->geterror() : OIIO::geterror()));
  return bytes;
}

}  // namespace

Spectrum tone_mapped(const Spectrum& linear, float exposure_stops, ToneMap tone_map) {
  return limited(max(linear * std::exp2(exposure_stops), Spectrum(0.0f)), tone_map);
}

Spectrum display_colour(const Spectrum& linear, float exposure_stops, ToneMap tone_map) {
  if (std::isnan(linear.r) || std::isnan(linear.g) || std::isnan(linear.b)) return rgb(1, 0, 1);
  const Spectrum exposed = max(linear * std::exp2(exposure_stops), Spectrum(0.0f));
  if (!is_finite(exposed)) return white;
  const Spectrum c = limited(exposed, tone_map);
  return rgb(srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b));
}

void write_png(const std::string& path, int width, int height, std::span<const Spectrum> linear,
               float exposure_stops, ToneMap tone_map) {
  assert(linear.size() == static_cast<std::size_t>(width) * height);
  AtomicFile file(path);
  const std::vector<unsigned char> bytes =
      compressed(path, width, height, encoded(linear, exposure_stops, tone_map));
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  file.commit();
}

}  // namespace umbral
