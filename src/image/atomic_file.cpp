// A temporary file, then rename(2).
#include "image/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"

namespace umbral {
namespace {

namespace fs = std::filesystem;

// Unique among all running processes that write to the directory, and short: the target's name may be as long
// as the file system allows.
fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return target.parent_path() / fmt::format(".umbral-{}-{}.part", ::getpid(), count++);
}

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw OutputError(fmt::format("cannot write '{}': {}", path, reason));
}

// The file to replace: what `path` links to, if it is a link.
fs::path resolved(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(path), error);
  if (error) refuse(path, error.message());
  return target;
}

void require_replaceable(const std::string& path, const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) refuse(path, "it is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(path, "it is not a regular file");
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0) refuse(path, "it is write-protected");
  if (!fs::is_directory(target.parent_path(), error))
    refuse(path, fmt::format("there is no directory '{}'", target.parent_path().string()));
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {
  if (path_.empty() || path_.back() == '/') refuse(path_, "it does not name a file");
  const fs::path target = resolved(path_);
  require_replaceable(path_, target);
  target_ = target.string();
  std::string temporary = temporary_name(target).string();
  file_ = std::fopen(temporary.c_str(), "wbx");
  if (!file_) fail(errno);
  temporary_ = std::move(temporary);
}

AtomicFile::~AtomicFile() {
  if (file_) std::fclose(file_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void AtomicFile::write(std::span<const char> bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail(errno);
  position_ += bytes.size();
}

void AtomicFile::seek(std::uint64_t position) {
  if (::fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail(errno);
  position_ = position;
}

void AtomicFile::check() {
  if (error_ != 0) fail(error_);
}

void AtomicFile::commit() {
  check();
  std::FILE* const file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) fail(errno);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void AtomicFile::fail(int error) {
  if (error_ == 0) error_ = error != 0 ? error : EIO;
  refuse(path_, std::generic_category().message(error_));
}

void write_file(const std::string& path, std::span<const char> bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace umbral
