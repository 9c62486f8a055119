// SIGPROF against the address ranges of Embree's library.
#include "embree_share.h"

#include <sys/time.h>
#include <ucontext.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace umbral::bench {
namespace {

struct AddressRange {
  std::uintptr_t begin, end;
};

std::vector<AddressRange> embree_ranges;
std::atomic<std::uint64_t> inside{0}, total{0};

std::vector<AddressRange> ranges_of(const std::string& library) {
  std::vector<AddressRange> ranges;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    unsigned long begin = 0, end = 0;
    if (line.find(library) == std::string::npos) continue;
    if (std::sscanf(line.c_str(), "%lx-%lx", &begin, &end) == 2) ranges.push_back({begin, end});
  }
  return ranges;
}

void on_profile_signal(int, siginfo_t*, void* context) {
  const auto counter =
      static_cast<std::uintptr_t>(static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
  total.fetch_add(1, std::memory_order_relaxed);
  for (const AddressRange& range : embree_ranges)
    if (counter >= range.begin && counter < range.end) inside.fetch_add(1, std::memory_order_relaxed);
}

void set_timer(long microseconds) {
  const itimerval timer{{0, microseconds}, {0, microseconds}};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

EmbreeShare::EmbreeShare() {
  embree_ranges = ranges_of("libembree");
  inside = total = 0;
  struct sigaction action {};
  action.sa_sigaction = on_profile_signal;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  set_timer(1000);
}

EmbreeShare::~EmbreeShare() { set_timer(0); }

double EmbreeShare::share() const { return static_cast<double>(inside) / static_cast<double>(total); }
std::uint64_t EmbreeShare::samples() const { return total; }

}  // namespace umbral::bench
