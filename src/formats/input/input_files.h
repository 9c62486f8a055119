// InputFiles: reads files and keeps the hash of all their bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace umbral {

// Whether the file is one that InputFiles unpacks.
bool is_packed(const std::filesystem::path& path);

class InputFiles {
 public:
  // The bytes of the file, or what was packed into one whose name ends in .gz. Throws SceneError, located in that file, if it cannot be read.
  std::string read(const std::filesystem::path& path);

  // Adds a file to the hash that someone else reads.
  void add_to_hash(const std::filesystem::path& path);

  // Of the bytes of every file so far, each once, in the order of its first reading; their names do not
  // matter.
  std::uint64_t hash() const { return hash_; }

 private:
  std::set<std::filesystem::path> seen_;
  std::uint64_t hash_ = 0;
};

}  // namespace umbral
