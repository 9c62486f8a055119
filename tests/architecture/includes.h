// Finds the includes of src/ that go against the arrows between its rooms.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace umbral::test {

/// An include, or a file, that the architecture forbids.
struct Violation {
  std::string file;     // from the root of src/
  int line;             // from 1
  std::string include;  // with its quotes or angle brackets; empty if the file as a whole is out of place
  std::string reason;

  /// "src/core/a.h:3: #include \"image/film.h\": core may include core only"
  std::string text() const;
};

/// What was read, and what was wrong with it; violations are ordered by file and line.
struct Inspection {
  std::vector<std::string> rooms;  // that hold at least one source file
  int files = 0;
  std::vector<Violation> violations;
};

/// Reads every .h and .cpp file below `src`, a directory laid out like src/.
Inspection inspect_includes(const std::filesystem::path& src);

}  // namespace umbral::test
