// The progress of a render on a terminal, or as plain lines where there is none.
#pragma once

#include <string>

#include "render/renderer.h"

namespace umbral {

class ProgressBar {
 public:
  // On stderr; `target` is the relative error asked for, 0 if none.
  explicit ProgressBar(double target);

  void show(const RenderProgress& progress);
  // Clears the bar.
  void finish();

 private:
  bool terminal_;
  double target_;
  double next_ = 0;  // seconds from the start
  bool shown_ = false;
};

// "[########            ]  42 %  12.3 s, 16.8 s left  error 1.8 % → 1.0 %".
std::string progress_text(const RenderProgress& progress, double target, bool with_bar);

}  // namespace umbral
