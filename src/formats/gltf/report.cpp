// Messages about glTF files.
#include "formats/gltf/report.h"

#include <fmt/format.h>

namespace umbral::gltf {
namespace {

constexpr std::size_t most_errors = 50;  // a broken file can have one in each of its values

std::string located(const std::string& path, const std::string& message) {
  return path.empty() ? message : fmt::format("{}: {}", path, message);
}

// "/nodes/*/extras" for "/nodes/12/extras".
std::string without_indices(const std::string& path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool digit = path[i] >= '0' && path[i] <= '9';
    if (digit && text.ends_with("/*")) continue;
    text += digit && text.ends_with('/') ? '*' : path[i];
  }
  return text;
}

}  // namespace

void Report::error(const std::string& path, const std::string& message) {
  if (++errors_ <= most_errors) diagnostics_.error({{file_}}, located(path, message));
  if (errors_ == most_errors + 1) diagnostics_.error({{file_}}, "there are more errors");
}

void Report::warning(const std::string& path, const std::string& message) {
  const std::string alike = without_indices(path) + ' ' + message;
  const auto [entry, is_new] = known_.try_emplace(alike, warnings_.size());
  if (is_new) warnings_.push_back({path, message});
  ++warnings_[entry->second].count;
}

void Report::finish() {
  for (const Kept& kept : warnings_) {
    const std::string more = kept.count == 1 ? "" : fmt::format(" (and {} more like it)", kept.count - 1);
    diagnostics_.warning({{file_}}, located(kept.path, kept.message) + more);
  }
  warnings_.clear();
  known_.clear();
}

}  // namespace umbral::gltf
