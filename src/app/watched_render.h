// WatchedRender: the hooks of a render that a person waits for: its progress on stderr, and Ctrl-C.
#pragma once

#include "app/interrupt.h"
#include "app/progress_bar.h"

namespace umbral {

class WatchedRender {
 public:
  // `target` is the relative error asked for, 0 if none; `quiet` shows nothing.
  explicit WatchedRender(bool quiet, double target = 0) : bar_(target) {
    hooks_.cancelled = &interrupt_.flag();
    if (!quiet) hooks_.progress = [this](const RenderProgress& progress) { bar_.show(progress); };
  }
  ~WatchedRender() { bar_.finish(); }
  WatchedRender(const WatchedRender&) = delete;
  WatchedRender& operator=(const WatchedRender&) = delete;

  const RenderHooks& hooks() const { return hooks_; }

 private:
  InterruptGuard interrupt_;
  ProgressBar bar_;
  RenderHooks hooks_;
};

}  // namespace umbral
