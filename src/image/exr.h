// OpenEXR files of 32-bit float channels: whole or not at all.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace umbral {

struct ExrChannel {
  std::string name;           // "R", "stderr.G", …
  std::vector<float> pixels;  // of the data window, row by row from the top
  bool half = false;          // whether the file that it was read from holds 16-bit numbers
};

using ExrAttribute = std::variant<int, float, double, std::string>;

// A single-part image. The data window lies in the display window, whose corner is (0, 0).
struct ExrImage {
  int width = 0, height = 0;           // of the display window, pixels
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // data window: x0 ≤ x < x1, y0 ≤ y < y1, y down
  std::vector<ExrChannel> channels;
  std::map<std::string, ExrAttribute> attributes;  // those of the four types above, without the standard ones

  // nullptr if there is none.
  const ExrChannel* find(std::string_view name) const;
  // The attribute, or nullptr if there is none of that name and type.
  template <class T>
  const T* attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? nullptr : std::get_if<T>(&found->second);
  }
};

// Writes scan lines compressed by ZIP, with Rec. 709 chromaticities. The file appears under its name when it
// is complete (see AtomicFile). Throws OutputError.
void write_exr(const std::string& path, const ExrImage& image);

// Reads the first part of any scan-line or tiled file, of which those channels that are `wanted`, all without it; half
// and integer channels become float. A data window that reaches out of the display window is kept as it is. Throws SceneError if the file is missing,
// truncated, not an OpenEXR image, deep, or has subsampled channels.
ExrImage read_exr(const std::string& path, const std::function<bool(const std::string&)>& wanted = {});

}  // namespace umbral
