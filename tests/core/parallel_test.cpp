// The parallel loop.
#include "core/parallel.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace umbral {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
  std::vector<std::atomic<int>> calls(10'007);
  parallel_for(calls.size(), [&](std::size_t i) { ++calls[i]; });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
  parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, RethrowsWhatABodyThrows) {
  std::atomic<int> running = 0;
  try {
    parallel_for(1000, [&](std::size_t i) {
      ++running;
      if (i == 500) {
        --running;
        throw std::runtime_error("body 500");
      }
      --running;
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "body 500");
    EXPECT_EQ(running, 0) << "every running call has ended";
  }
}

TEST(ParallelFor, WorksWithinItself) {
  std::atomic<int> calls = 0;
  parallel_for(20, [&](std::size_t) { parallel_for(30, [&](std::size_t) { ++calls; }); });
  EXPECT_EQ(calls, 600);
}

TEST(ThreadLimit, OneMeansOne) {
  const ThreadLimit limit(1);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallel_for(50, [&](std::size_t) {
    std::this_thread::sleep_for(
        std::chrono::milliseconds(1));  // long enough for others to join, if they might
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads.size(), 1u);
  EXPECT_TRUE(threads.contains(std::this_thread::get_id()));
}

TEST(AvailableThreads, IsAtLeastOne) { EXPECT_GE(available_threads(), 1); }

}  // namespace
}  // namespace umbral
