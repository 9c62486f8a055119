// One reader under libFuzzer: any bytes load or are refused with a SceneError; whatever else happens is a finding.
//
// UMBRAL_FUZZ_FILE is the file that the bytes become, UMBRAL_FUZZ_SCENE the one that is read.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "formats/scene_file.h"

namespace {

// A folder of its own for each process, so that several run at a time.
const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    auto path = std::filesystem::temp_directory_path() / ("umbral-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
    // What is read where the fuzzed file is named by another.
    std::ofstream(path / "uses_mtl.obj")
        << "mtllib fuzzed.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\nusemtl n\nf 1 3 2\n";
    return path;
  }();
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::ofstream(folder() / UMBRAL_FUZZ_FILE, std::ios::binary)
      << std::string_view(reinterpret_cast<const char*>(data), size);
  umbral::IntegratorKinds integrators;
  integrators.kinds = {"path"};
  integrators.default_kind = "path";
  integrators.read = [](const std::string&, umbral::ParameterVisitor&) {};
  try {
    umbral::read_scene_file(folder() / UMBRAL_FUZZ_SCENE, integrators);
  } catch (const umbral::SceneError&) {
  }
  return 0;
}
