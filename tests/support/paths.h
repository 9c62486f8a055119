// Where tests find the project's own files, the scenes that may be kept beside it, and room for their own.
#pragma once

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include <unistd.h>

namespace umbral::test {

/// A file of the project by its path from the root: source_path("scenes/cornell-box/cornell-box.toml").
inline std::filesystem::path source_path(const std::filesystem::path& relative) {
  return std::filesystem::path(UMBRAL_SOURCE_DIR) / relative;
}

/// A file among the shared scenes, which are not part of the project: below the directory named by the
/// environment variable UMBRAL_SHARED_SCENES, else below ../shared/scenes. Nothing if it is not there:
///
///   const auto scene = shared_scene("robustness/scene.toml");
///   if (!scene) GTEST_SKIP() << no_shared_scenes;
inline std::optional<std::filesystem::path> shared_scene(const std::filesystem::path& relative) {
  const char* chosen = std::getenv("UMBRAL_SHARED_SCENES");
  const std::filesystem::path root = chosen ? std::filesystem::path(chosen) : source_path("../shared/scenes");
  std::error_code absent;
  const std::filesystem::path path = std::filesystem::weakly_canonical(root / relative, absent);
  if (absent || !std::filesystem::exists(path, absent)) return std::nullopt;
  return path;
}

inline constexpr const char* no_shared_scenes =
    "the shared scenes are not here: set UMBRAL_SHARED_SCENES to their directory";

/// A fresh directory that is deleted, with all it holds, at the end of the scope.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    static std::atomic<int> count = 0;
    const std::string name = "umbral-test-" + std::to_string(getpid()) + "-" + std::to_string(++count);
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace umbral::test
