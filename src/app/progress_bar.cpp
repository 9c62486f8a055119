// Redrawn ever more slowly, as a long render needs less attention.
#include "app/progress_bar.h"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

namespace umbral {
namespace {

std::string duration(double seconds) {
  if (seconds < 99.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

std::string progress_text(const RenderProgress& progress, double target, bool with_bar) {
  std::string text;
  if (with_bar) {
    constexpr int width = 20;
    const int filled = static_cast<int>(progress.share * width);
    text = "[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] ";
  }
  text += fmt::format("{:3.0f} %  {}", 100 * progress.share, duration(progress.elapsed));
  if (progress.share > 0.01 || progress.elapsed > 2) {
    const double left = progress.elapsed * (1 / std::max(progress.share, 1e-6) - 1);
    text += fmt::format(", {} left", duration(left));
  }
  if (std::isfinite(progress.relative_error))
    text += fmt::format("  error {:.2g} %", 100 * progress.relative_error);
  if (target > 0) text += fmt::format(" → {:.2g} %", 100 * target);
  return text;
}

ProgressBar::ProgressBar(double target) : terminal_(isatty(STDERR_FILENO) == 1), target_(target) {}

void ProgressBar::show(const RenderProgress& progress) {
  if (progress.elapsed < next_) return;
  const double interval = terminal_ ? 0.1 + progress.elapsed / 200 : 5 + progress.elapsed / 10;
  next_ = progress.elapsed + interval;
  if (!terminal_ && progress.elapsed < 2) return;  // a short render needs no lines
  const std::string text = progress_text(progress, target_, terminal_);
  if (terminal_)
    fmt::print(stderr, "\r{}\x1b[K", text);
  else
    fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressBar::finish() {
  if (terminal_ && shown_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace umbral
