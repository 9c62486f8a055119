// Parallelism by oneTBB, which Embree uses too: one pool of threads for both.
#include "core/parallel.h"

#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

namespace umbral {

struct ThreadLimit::Impl {
  tbb::global_control control;
};

int available_threads() { return std::max(1, tbb::info::default_concurrency()); }

ThreadLimit::ThreadLimit(int threads)
    : impl_(new Impl{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                         static_cast<std::size_t>(std::max(1, threads)))}) {}

ThreadLimit::~ThreadLimit() = default;

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  tbb::parallel_for(std::size_t{0}, count, body, tbb::simple_partitioner());
}

}  // namespace umbral
