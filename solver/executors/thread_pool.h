#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace trajan {

/// How a thread waits. What a step waits for comes within microseconds, and a thread that sleeps wakes up some
/// tens of them late, on a virtual machine above all; so it asks again and again for a while before it sleeps,
/// unless that has been in vain of late, as where others want the processors. Two threads take 13 -> 10.2 ns per
/// particle and step for discs of 10^5 particles, 64 -> 18 for 10^4 and 370 -> 27 for 10^3, but 33 -> 40
/// for 10^4 beside a second such job on the same two processors.
class Patience {
 public:
  /// Returns once `of`, of which others are told when it changes, is not `same`.
  void wait_while(const std::atomic<std::uint32_t>& of, std::uint32_t same);

 private:
  int in_vain_ = 0;  ///< in a row
  unsigned waits_ = 0;
};

/// Threads that live as long as the pool. The calling thread is number 0.
class ThreadPool {
 public:
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return static_cast<int>(workers_.size()) + 1; }
  /// Calls task(0) ... task(size() - 1), each on its thread, and returns when all have returned. The task
  /// must not throw.
  void run(const std::function<void(int)>& task);

 private:
  void begin(const std::function<void(int)>* task);
  void work(int thread);

  const std::function<void(int)>* task_ = nullptr;  ///< nullptr: it is time to end
  std::atomic<std::uint32_t> begun_ = 0;            ///< tasks
  std::atomic<std::uint32_t> running_ = 0;          ///< workers that have not returned from the task
  Patience patience_;                               ///< of the calling thread
  std::vector<std::thread> workers_;
};

}  // namespace trajan
