// Collection and order of diagnostics.
#include "formats/input/diagnostics.h"

#include <algorithm>
#include <tuple>

namespace umbral {

void Diagnostics::name_file(const std::string& file) {
  if (rank(file) == files_.size()) files_.push_back(file);
}

void Diagnostics::add(Severity severity, const Place& place, std::string message) {
  name_file(place.where.file);
  if (severity == Severity::error) ++error_count_;
  all_.push_back({severity, place.where, std::move(message), place.excerpt()});
}

void Diagnostics::add(Severity severity, const Place& place, const SceneError& error) {
  for (const Diagnostic& diagnostic : error.diagnostics()) {
    const std::string& file = diagnostic.where.file;
    add(severity, place,
        file.empty() || file == place.where.file ? diagnostic.message : file + ": " + diagnostic.message);
  }
}

void Diagnostics::adopt(const SceneError& error) {
  for (const Diagnostic& diagnostic : error.diagnostics()) {
    name_file(diagnostic.where.file);
    if (diagnostic.severity == Severity::error) ++error_count_;
    all_.push_back(diagnostic);
  }
}

void Diagnostics::throw_errors() const {
  if (has_errors()) throw SceneError(sorted(Severity::error));
}

std::size_t Diagnostics::rank(const std::string& file) const {
  return static_cast<std::size_t>(std::find(files_.begin(), files_.end(), file) - files_.begin());
}

std::vector<Diagnostic> Diagnostics::sorted(Severity severity) const {
  std::vector<Diagnostic> chosen;
  for (const Diagnostic& diagnostic : all_)
    if (diagnostic.severity == severity) chosen.push_back(diagnostic);
  std::stable_sort(chosen.begin(), chosen.end(), [this](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(rank(a.where.file), a.where.line, a.where.column) <
           std::tuple(rank(b.where.file), b.where.line, b.where.column);
  });
  return chosen;
}

}  // namespace umbral
