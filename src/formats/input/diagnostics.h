// Diagnostics: every error and warning found while a scene is read, in the order of the files.
#pragma once

#include <string>
#include <vector>

#include "formats/input/source_text.h"

namespace umbral {

class Diagnostics {
 public:
  void error(const Place& place, std::string message) { add(Severity::error, place, std::move(message)); }
  void warning(const Place& place, std::string message) { add(Severity::warning, place, std::move(message)); }
  // Those of `error`, each told again at `place`, which names the file that it speaks of.
  void error(const Place& place, const SceneError& error) { add(Severity::error, place, error); }
  void warning(const Place& place, const SceneError& error) { add(Severity::warning, place, error); }
  // Those of `error` as they are.
  void adopt(const SceneError& error);

  // The files are told in the order in which they were named here.
  void name_file(const std::string& file);

  bool has_errors() const { return error_count() > 0; }
  std::size_t error_count() const { return error_count_; }
  // Throws SceneError with all errors if there are any.
  void throw_errors() const;
  std::vector<Diagnostic> warnings() const { return sorted(Severity::warning); }

 private:
  void add(Severity severity, const Place& place, std::string message);
  void add(Severity severity, const Place& place, const SceneError& error);
  std::vector<Diagnostic> sorted(Severity severity) const;
  std::size_t rank(const std::string& file) const;

  std::vector<Diagnostic> all_;
  std::size_t error_count_ = 0;
  std::vector<std::string> files_;
};

}  // namespace umbral
