// The progress of a render on a terminal, or as plain lines where there is none.
#pragma once

#include <string>

#include "app/progress_line.h"
#include "render/renderer.h"

namespace umbral {

class ProgressBar {
 public:
  // On stderr; `target` is the relative error asked for, 0 if none.
  explicit ProgressBar(double target) : target_(target) {}

  void show(const RenderProgress& progress);
  // Clears the bar.
  void finish() { line_.clear(); }

 private:
  double target_;
  ProgressLine line_{0};
};

// "[########            ]  42 %  12.3 s, 16.8 s left  error 1.8 % → 1.0 %".
std::string progress_text(const RenderProgress& progress, double target, bool with_bar);

}  // namespace umbral
