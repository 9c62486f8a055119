// The words of a progress bar.
#include "app/progress_bar.h"

#include <fmt/format.h>

namespace umbral {

std::string progress_text(const RenderProgress& progress, double target, bool with_bar) {
  std::string text;
  if (with_bar) {
    constexpr int width = 20;
    const int filled = static_cast<int>(progress.share * width);
    text = "[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] ";
  }
  text += fmt::format("{:3.0f} %  {}", 100 * progress.share, duration_text(progress.elapsed));
  if (progress.share > 0.01 || progress.elapsed > 2) {
    const double left = progress.elapsed * (1 / std::max(progress.share, 1e-6) - 1);
    text += fmt::format(", {} left", duration_text(left));
  }
  if (std::isfinite(progress.relative_error))
    text += fmt::format("  error {:.2g} %", 100 * progress.relative_error);
  if (target > 0) text += fmt::format(" → {:.2g} %", 100 * target);
  return text;
}

void ProgressBar::show(const RenderProgress& progress) {
  if (line_.is_due(progress.elapsed)) line_.show(progress_text(progress, target_, line_.is_terminal()));
}

}  // namespace umbral
