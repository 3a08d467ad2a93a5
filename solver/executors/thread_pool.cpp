#include "solver/executors/thread_pool.h"

#include <emmintrin.h>

#include <chrono>

namespace trajan {

void Patience::wait_while(const std::atomic<std::uint32_t>& of, std::uint32_t same) {
  using std::chrono::steady_clock;
  if (in_vain_ < 3 || ++waits_ % 16 == 0) {
    const auto end = steady_clock::now() + std::chrono::microseconds(50);
    do
      for (int tries = 0; tries < 32; ++tries) {
        if (of.load(std::memory_order_acquire) != same) {
          in_vain_ = 0;
          return;
        }
        _mm_pause();
      }
    while (steady_clock::now() < end);
    ++in_vain_;
  }
  of.wait(same, std::memory_order_acquire);
}

ThreadPool::ThreadPool(int threads) {
  for (int thread = 1; thread < threads; ++thread) workers_.emplace_back([this, thread] { work(thread); });
}

ThreadPool::~ThreadPool() {
  begin(nullptr);
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::begin(const std::function<void(int)>* task) {
  task_ = task;
  running_.store(static_cast<std::uint32_t>(workers_.size()), std::memory_order_relaxed);
  begun_.fetch_add(1, std::memory_order_release);
  begun_.notify_all();
}

void ThreadPool::run(const std::function<void(int)>& task) {
  if (workers_.empty()) {
    task(0);
    return;
  }
  begin(&task);
  task(0);
  while (const std::uint32_t left = running_.load(std::memory_order_acquire)) patience_.wait_while(running_, left);
}

void ThreadPool::work(int thread) {
  Patience patience;
  for (std::uint32_t seen = 0;; ++seen) {
    patience.wait_while(begun_, seen);
    if (!task_) return;
    (*task_)(thread);
    if (running_.fetch_sub(1, std::memory_order_release) == 1) running_.notify_one();
  }
}

}  // namespace trajan
