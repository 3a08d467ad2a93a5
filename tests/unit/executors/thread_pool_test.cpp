#include "solver/executors/thread_pool.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

namespace trajan {
namespace {

using std::chrono::milliseconds;

/// What tasks write is not atomic: the thread sanitizer finds what is not waited for.
TEST(ThreadPool, CallsATaskOnceOnEachThreadAndWaitsForAll) {
  constexpr std::size_t threads = 3;
  ThreadPool pool(threads);
  std::array<int, threads> calls{}, seen_by_next{};
  for (int run = 0; run < 1000; ++run) {
    // Now and then the caller is late, or one of the threads: then those that wait have fallen asleep. Where one
    // is late many times in a row they sleep at once.
    const bool many = run >= 400 && run < 440;
    if (run % 300 == 0) std::this_thread::sleep_for(milliseconds(3));
    pool.run([&](int thread) {
      const auto t = static_cast<std::size_t>(thread);
      if (run % 300 == 50 * (thread + 1) || (many && thread == 1)) std::this_thread::sleep_for(milliseconds(3));
      ++calls[t];
    });
    pool.run([&](int thread) {
      const auto t = static_cast<std::size_t>(thread);
      seen_by_next[t] = calls[(t + 1) % threads];
    });
    for (std::size_t t = 0; t < threads; ++t) {
      ASSERT_EQ(calls[t], run + 1) << "thread " << t;
      ASSERT_EQ(seen_by_next[t], run + 1) << "thread " << t;
    }
  }
}

std::atomic<int> ended = 0;
struct CountsWhenItsThreadEnds {
  ~CountsWhenItsThreadEnds() { ++ended; }
};

/// One that does not hangs here.
TEST(ThreadPool, EndsItsThreadsWhetherTheySleepOrHaveNotBegun) {
  for (int i = 0; i < 100; ++i) ThreadPool at_once(3);
  for (const milliseconds asleep : {milliseconds(0), milliseconds(3)}) {
    ended = 0;
    {
      ThreadPool pool(3);
      pool.run([](int thread) {
        if (thread > 0) thread_local const CountsWhenItsThreadEnds counter;
      });
      std::this_thread::sleep_for(asleep);
      EXPECT_EQ(ended, 0);
    }
    EXPECT_EQ(ended, 2) << asleep.count() << " ms";
  }
}

TEST(ThreadPool, OfOneThreadIsTheCaller) {
  ThreadPool pool(1);
  std::thread::id where;
  pool.run([&](int) { where = std::this_thread::get_id(); });
  EXPECT_EQ(where, std::this_thread::get_id());
}

}  // namespace
}  // namespace trajan
