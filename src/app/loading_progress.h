// LoadingProgress: what a scene on its way into memory is waiting for, told once that takes longer than a moment.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "app/progress_line.h"

namespace umbral {

// Shown on stderr while it lives.
class LoadingProgress {
 public:
  // `quiet` shows nothing.
  LoadingProgress(std::string phase, bool quiet);
  ~LoadingProgress();
  LoadingProgress(const LoadingProgress&) = delete;
  LoadingProgress& operator=(const LoadingProgress&) = delete;

  // "textures 12/40" until all are decoded, then the phase again. From any thread.
  void decoded(std::size_t done, std::size_t count);

 private:
  void watch(const std::stop_token& stop);

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string phase_, now_;
  ProgressLine line_{0.5};
  std::mutex mutex_;  // of now_
  std::condition_variable_any stopped_;
  std::jthread watcher_;  // readers have no clock of their own
};

}  // namespace umbral
