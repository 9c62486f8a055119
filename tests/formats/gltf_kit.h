// Small glTF files made by tests.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "scene_folder.h"

namespace umbral::test {

// Bytes of a buffer, and where its parts begin.
class GltfBytes {
 public:
  template <class T>
  std::size_t add(const std::vector<T>& values) {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    const std::size_t offset = bytes_.size();
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return offset;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

inline std::string base64(const std::string& bytes) {
  static constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

inline std::string data_uri(const std::string& bytes) {
  return "data:application/octet-stream;base64," + base64(bytes);
}

// A file with one buffer; `json` is what stands beside "asset" and "buffers", beginning with a comma where not empty.
inline std::string gltf(const std::string& bytes, const std::string& json) {
  return fmt::format(R"({{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": {}, "uri": "{}"}}]{}}})",
                     bytes.size(), data_uri(bytes), json);
}

// The same as a container.
inline std::string glb(const std::string& bytes, const std::string& json) {
  std::string text = fmt::format(R"({{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": {}}}]{}}})",
                                 bytes.size(), json);
  std::string binary = bytes;
  while (text.size() % 4 != 0) text += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const auto number = [](std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&word), 4);
  };
  return "glTF" + number(2) + number(28 + text.size() + binary.size()) + number(text.size()) + "JSON" + text +
         number(binary.size()) + std::string("BIN\0", 4) + binary;
}

// A square of side 2 around the origin in the plane z = 0, facing +z, with uv from (0, 0) at its upper left corner as
// glTF counts; accessors 0 POSITION, 1 NORMAL, 2 TEXCOORD_0, 3 indices.
struct GltfSquare {
  GltfBytes bytes;
  std::string parts;  // "bufferViews" and "accessors", after a comma

  explicit GltfSquare(const std::string& more_views = "", const std::string& more_accessors = "") {
    bytes.add<float>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    bytes.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    bytes.add<float>({0, 1, 1, 1, 1, 0, 0, 0});
    bytes.add<std::uint16_t>({0, 1, 2, 0, 2, 3});
    parts =
        R"(, "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 48},
           {"buffer": 0, "byteOffset": 96, "byteLength": 32}, {"buffer": 0, "byteOffset": 128, "byteLength": 12})" +
        more_views +
        R"(], "accessors": [
           {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
           {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
           {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
           {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"})" +
        more_accessors + "]";
  }

  // With the scene that shows all of `nodes`, of which none has children.
  std::string file(const std::string& nodes, std::size_t count, const std::string& rest = "",
                   const std::string& primitive = "") const {
    std::string roots;
    for (std::size_t i = 0; i < count; ++i) roots += (i == 0 ? "" : ", ") + std::to_string(i);
    return gltf(bytes.bytes(), parts + R"(, "meshes": [{"name": "square", "primitives": [{"attributes":
                {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3)" +
                                   primitive + R"(}]}], "nodes": [)" + nodes +
                                   R"(], "scenes": [{"nodes": [)" + roots + R"(]}], "scene": 0)" + rest);
  }
};

}  // namespace umbral::test
