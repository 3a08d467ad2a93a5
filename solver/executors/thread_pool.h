#pragma once

#include <barrier>
#include <functional>
#include <thread>
#include <vector>

namespace trajan {

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
  void work(int thread);

  const std::function<void(int)>* task_ = nullptr;
  std::barrier<> begin_;
  std::barrier<> end_;
  std::vector<std::thread> workers_;
};

}  // namespace trajan
