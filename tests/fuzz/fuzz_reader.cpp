// The readers under libFuzzer: any bytes load or are refused with a SceneError; whatever else happens is a finding.
//
// fuzz_reader --reader=KIND [--seeds=FOLDER] LIBFUZZER'S ARGUMENTS…
//   --reader  what the bytes are: the ending of a sample of tests/formats/samples.h, or exr, an image with statistics
//   --seeds   writes the samples of that kind into a folder first
// fuzz_reader --readers  lists the kinds
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "formats/samples.h"
#include "formats/scene_file.h"
#include "image/film_file.h"
#include "image/texture_image.h"

namespace umbral::test {
namespace {

std::string reader_name;

std::string kind_of(const Sample& sample) {
  return std::filesystem::path(sample.file).extension().string().substr(1);
}

std::set<std::string> readers() {
  std::set<std::string> kinds{"exr"};
  for (const Sample& sample : samples()) kinds.insert(kind_of(sample));
  return kinds;
}

void write_seeds(const std::filesystem::path& folder) {
  for (const Sample& sample : samples())
    if (kind_of(sample) == reader_name) std::ofstream(folder / sample.file, std::ios::binary) << sample.bytes;
}

// One for the process, so that several run at a time. All samples are in it, for those that name others.
const SceneFolder& folder() {
  static const auto made = [] {
    auto folder = std::make_unique<SceneFolder>();
    for (const Sample& sample : samples()) folder->write(sample.file, sample.bytes);
    return folder;
  }();
  return *made;
}

// Read by itself: a scene with it would read the pictures beside it again each time.
bool is_picture() {
  static const std::set<std::string> pictures{"hdr", "jpg", "pfm", "png", "tga"};
  return pictures.contains(reader_name);
}

void read(const std::string& bytes) {
  if (reader_name == "exr") {
    folder().write("a.exr", bytes);
    read_film(folder().path("a.exr").string());
    return;
  }
  static const Sample sample = sample_of(reader_name);
  folder().write(sample.file, bytes);
  if (is_picture()) {
    std::vector<std::string> repairs;
    load_texture_image(folder().path(sample.file).string(), ColorSpace::automatic, repairs);
    return;
  }
  folder().read(sample.scene);
}

}  // namespace
}  // namespace umbral::test

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace umbral::test;
  std::filesystem::path seeds;
  for (int i = 1; i < *argc; ++i) {
    const std::string_view argument = (*argv)[i];
    if (argument == "--readers") {
      for (const std::string& kind : readers()) std::cout << kind << '\n';
      std::exit(0);
    }
    if (argument.starts_with("--reader=")) reader_name = argument.substr(9);
    if (argument.starts_with("--seeds=")) seeds = argument.substr(8);
  }
  if (!readers().contains(reader_name)) {
    std::cerr << "fuzz_reader --reader=KIND: there is no kind '" << reader_name << "'\n";
    std::exit(2);
  }
  if (!seeds.empty()) write_seeds(seeds);
  return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    umbral::test::read({reinterpret_cast<const char*>(data), size});
  } catch (const umbral::SceneError&) {
  }
  return 0;
}
