// A thread that looks on from time to time.
#include "app/loading_progress.h"

#include <fmt/format.h>

namespace umbral {

LoadingProgress::LoadingProgress(std::string phase, bool quiet) : phase_(std::move(phase)), now_(phase_) {
  if (!quiet) watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

LoadingProgress::~LoadingProgress() {
  if (!watcher_.joinable()) return;
  watcher_.request_stop();
  watcher_.join();
  line_.clear();
}

void LoadingProgress::decoded(std::size_t done, std::size_t count) {
  const std::lock_guard lock(mutex_);
  now_ = done < count ? fmt::format("textures {}/{}", done, count) : phase_;
}

void LoadingProgress::watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    stopped_.wait_for(lock, stop, std::chrono::milliseconds(100), [] { return false; });
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (!stop.stop_requested() && line_.is_due(elapsed))
      line_.show(fmt::format("{}  {}", now_, duration_text(elapsed)));
  }
}

}  // namespace umbral
