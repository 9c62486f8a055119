// AtomicFile: a file that appears under its name complete or not at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

namespace umbral {

// Writes to a temporary name beside `path`; commit() gives it its name. Without commit() the temporary file
// is removed and what was at `path` stays. An existing `path` must be a regular file (or a link to one) that
// may be written. Every function throws OutputError with one sentence that names `path`.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const char> bytes);
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);  // from the start

  // Fails again with the first error, for callers through whose hands its exception did not come.
  void check();
  // Checks too.
  void commit();

 private:
  [[noreturn]] void fail(int error);

  std::string path_;       // as the user named it
  std::string target_;     // what it links to
  std::string temporary_;  // empty once committed
  std::FILE* file_ = nullptr;
  std::uint64_t position_ = 0;
  int error_ = 0;  // the first errno
};

// A whole file at once.
void write_file(const std::string& path, std::span<const char> bytes);

}  // namespace umbral
