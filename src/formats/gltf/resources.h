// What URIs of a glTF file lead to: files beside it, and bytes written out in base64.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace umbral::gltf {

// A URI of a glTF file, taken apart [RFC 3986, RFC 2397].
struct Uri {
  bool is_data = false;
  std::string mime_type;       // of data
  std::string bytes;           // of data, decoded
  std::filesystem::path file;  // relative to the glTF file, percent signs decoded
};

// `fault` says what is wrong where it gives nothing: another scheme than data:, bad base64, an absolute path.
std::optional<Uri> parse_uri(std::string_view uri, std::string& fault);

}  // namespace umbral::gltf
