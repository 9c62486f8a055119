// Signal handlers.
#include "app/interrupt.h"

#include <chrono>
#include <csignal>

namespace umbral {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

using Clock = std::chrono::steady_clock;  // asks the system in a way that signal handlers may
std::atomic<Clock::rep> first_signal{0};
static_assert(std::atomic<Clock::rep>::is_always_lock_free);

// A second signal kills, unless it comes with the first: `timeout` sends its signal to the process and to its group.
void on_signal(int signal) {
  const Clock::rep now = Clock::now().time_since_epoch().count();
  if (!interrupted.exchange(true)) {
    first_signal = now;
  } else if (Clock::duration(now - first_signal) > std::chrono::seconds(1)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupted = false;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

// After an interruption what there is has still to be written.
InterruptGuard::~InterruptGuard() {
  if (interrupted) return;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& InterruptGuard::flag() const { return interrupted; }

}  // namespace umbral
