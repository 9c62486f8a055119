// Errors of the input, located in the file that caused them.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace umbral {

// A place in a file; line and column count from 1, 0 means unknown.
struct Where {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { warning, error };

// One thing to tell about an input: where, what, and the excerpt of the file that it speaks of.
struct Diagnostic {
  Severity severity = Severity::error;
  Where where;
  std::string message;
  std::string excerpt = {};  // the line of the file and, below it, a caret; empty if there is none to show

  // "scene.toml:12:9: error: message", then the excerpt.
  std::string text() const;
};

// What a broken input throws: every error that was found in it, at least one.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<Diagnostic> diagnostics);
  SceneError(Where where, const std::string& message);

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

// What a file that cannot be written throws: an unwritable path, a full disk.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The line `line` of `text` with a caret under `column`, both counted from 1; empty if there is no such line.
std::string excerpt_with_caret(const std::string& text, int line, int column);

}  // namespace umbral
