// A folder of input files that a test writes, and what reading them says.
#pragma once

#include <cstring>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "formats/scene_file.h"
#include "support/paths.h"

namespace umbral::test {

// Settings that stand for those of two integrators: "path" and "local".
struct StandInSettings {
  int max_depth = 7;
  Textured<float> weight{0.5f};
  std::map<std::string, int> reads;  // how often each kind was asked for
};

inline IntegratorKinds stand_in_integrators(StandInSettings& settings) {
  return {{"path", "local"}, "path", [&settings](const std::string& kind, ParameterVisitor& visitor) {
            ++settings.reads[kind];
            if (kind == "path") visitor(ParameterInfo{"max_depth", "", Range{0, 100}}, settings.max_depth);
            if (kind == "local") visitor(ParameterInfo{"weight", "", zero_to_one}, settings.weight);
          }};
}

class SceneFolder {
 public:
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::filesystem::remove(path(name));  // overwriting makes some file systems wait for the disk
    std::ofstream(path(name), std::ios::binary) << bytes;
  }

  SceneFile read(const std::string& name) const {
    StandInSettings settings;
    return read_scene_file(path(name), stand_in_integrators(settings));
  }

  // Writes and reads "scene.toml".
  SceneFile read_toml(const std::string& text) const {
    write("scene.toml", text);
    return read("scene.toml");
  }

  // The message of the SceneError that reading throws, without the folder's name; "no error" if it throws none.
  std::string errors(const std::string& name) const {
    try {
      read(name);
    } catch (const SceneError& error) {
      return without_folder(error.what());
    }
    return "no error";
  }

  std::string errors_of_toml(const std::string& text) const {
    write("scene.toml", text);
    return errors("scene.toml");
  }

  std::string warnings(const SceneFile& file) const {
    std::string text;
    for (const Diagnostic& warning : file.warnings) text += without_folder(warning.text()) + '\n';
    return text;
  }

  std::string without_folder(std::string text) const {
    const std::string folder = folder_.path().string() + "/";
    for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }

 private:
  TemporaryDirectory folder_;
};

// An uncompressed TGA file of 32 bits a pixel, all of one colour but for the alpha of the last pixel.
inline std::string tga(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b,
                       std::uint8_t alpha) {
  std::string bytes(18, '\0');
  bytes[2] = 2;
  bytes[12] = static_cast<char>(width);
  bytes[14] = static_cast<char>(height);
  bytes[16] = 32;
  bytes[17] = 8;
  for (int i = 0; i < width * height; ++i) {
    const std::uint8_t a = i + 1 == width * height ? alpha : 255;
    for (const std::uint8_t channel : {b, g, r, a}) bytes += static_cast<char>(channel);
  }
  return bytes;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace umbral::test
