// Texts of located errors.
#include "core/error.h"

#include <sstream>

#include <fmt/format.h>

namespace umbral {
namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += diagnostic.text();
  }
  return text;
}

}  // namespace

std::string Diagnostic::text() const {
  std::string text = where.file;
  if (where.line > 0) text += fmt::format(":{}", where.line);
  if (where.line > 0 && where.column > 0) text += fmt::format(":{}", where.column);
  if (!text.empty()) text += ": ";
  text += severity == Severity::error ? "error: " : "warning: ";
  text += message;
  if (!excerpt.empty()) text += '\n' + excerpt;
  return text;
}

SceneError::SceneError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

SceneError::SceneError(Where where, const std::string& message)
    : SceneError(std::vector<Diagnostic>{{Severity::error, std::move(where), message}}) {}

std::string excerpt_with_caret(const std::string& text, int line, int column) {
  std::istringstream lines(text);
  std::string content;
  for (int i = 0; i < line; ++i)
    if (!std::getline(lines, content)) return {};
  if (!content.empty() && content.back() == '\r') content.pop_back();
  std::string pad;
  for (int i = 0; i + 1 < column && i < static_cast<int>(content.size()); ++i)
    pad += content[i] == '\t' ? '\t' : ' ';
  return fmt::format("{:5} | {}\n      | {}^", line, content, pad);
}

}  // namespace umbral
