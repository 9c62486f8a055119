// Parallelism by oneTBB, which Embree uses too: one pool of threads for both.
#include "core/parallel.h"

#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#ifdef UMBRAL_SANITIZE_THREAD
#include <sanitizer/tsan_interface.h>
#endif

namespace umbral {
namespace {

// TBB is not built for the thread sanitizer, which has to be told that a loop comes after what stands before it, and before
// what follows: what is handed over at one address happens before what is received there.
#ifdef UMBRAL_SANITIZE_THREAD
void hand_over(void* address) { __tsan_release(address); }
void receive(void* address) { __tsan_acquire(address); }
#else
void hand_over(void*) {}
void receive(void*) {}
#endif

// Does it at the end of a scope, by an exception too.
struct AtEnd {
  void (*act)(void*);
  void* address;
  ~AtEnd() { act(address); }
};

}  // namespace

struct ThreadLimit::Impl {
  tbb::global_control control;
};

int available_threads() { return std::max(1, tbb::info::default_concurrency()); }

ThreadLimit::ThreadLimit(int threads)
    : impl_(new Impl{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(std::max(1, threads)))}) {}

ThreadLimit::~ThreadLimit() = default;

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  char begin = 0, end = 0;
  hand_over(&begin);
  const auto handed_body = [&](std::size_t i) {
    receive(&begin);
    const AtEnd done{hand_over, &end};
    body(i);
  };
  const AtEnd all_done{receive, &end};
  tbb::parallel_for(std::size_t{0}, count, handed_body, tbb::simple_partitioner());
}

}  // namespace umbral
