// Whole files into memory, and their hash.
#include "formats/input/input_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/hash.h"
#include "formats/input/gzip.h"

namespace umbral {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
  throw SceneError(Where{path.string()}, "cannot be read: " + reason);
}

std::string bytes_of(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (failure) refuse(path, failure.message());
  if (std::filesystem::is_directory(status)) refuse(path, "it is a directory");
  if (std::filesystem::is_character_file(status)) refuse(path, "it is a device");
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse(path, std::strerror(errno));
  std::string bytes;
  std::size_t used = 0, wanted = 0;
  if (std::filesystem::is_regular_file(status)) wanted = std::filesystem::file_size(path, failure) + 1;
  do {  // a pipe tells no size
    bytes.resize(std::max<std::size_t>({wanted, 2 * used, 1 << 16}));
    used += std::fread(bytes.data() + used, 1, bytes.size() - used, file.get());
  } while (used == bytes.size());
  if (std::ferror(file.get())) refuse(path, std::strerror(errno));
  bytes.resize(used);
  return bytes;
}

std::uint64_t hash_of(std::string_view bytes) {
  std::uint64_t hash = bytes.size();
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    hash = mix64(hash ^ word) + 0x9e3779b97f4a7c15ull;
  }
  return hash;
}

}  // namespace

bool is_packed(const std::filesystem::path& path) { return path.extension() == ".gz"; }

std::string InputFiles::read(const std::filesystem::path& path) {
  std::string bytes = bytes_of(path);
  if (seen_.insert(path).second) hash_ = hash_combine(hash_, hash_of(bytes));
  return is_packed(path) ? unpacked(bytes, path.string()) : bytes;
}

void InputFiles::add_to_hash(const std::filesystem::path& path) {
  if (!seen_.contains(path)) read(path);
}

}  // namespace umbral
