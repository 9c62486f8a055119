// Writing over a line, and when.
#include "app/progress_line.h"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

namespace umbral {

ProgressLine::ProgressLine(double patience)
    : terminal_(isatty(STDERR_FILENO) == 1), next_(terminal_ ? patience : 2) {}

bool ProgressLine::is_due(double elapsed) {
  if (elapsed < next_) return false;
  next_ = elapsed + (terminal_ ? 0.1 + elapsed / 200 : 5 + elapsed / 10);
  return true;
}

void ProgressLine::show(const std::string& text) {
  if (terminal_)
    fmt::print(stderr, "\r{}\x1b[K", text);
  else
    fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  if (terminal_ && shown_) fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
}

std::string duration_text(double seconds) {
  if (seconds < 99.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace umbral
