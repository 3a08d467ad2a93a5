#include "solver/executors/thread_pool.h"

namespace trajan {

ThreadPool::ThreadPool(int threads) : begin_(threads), end_(threads) {
  for (int thread = 1; thread < threads; ++thread) workers_.emplace_back([this, thread] { work(thread); });
}

ThreadPool::~ThreadPool() {
  if (workers_.empty()) return;
  task_ = nullptr;
  begin_.arrive_and_wait();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run(const std::function<void(int)>& task) {
  if (workers_.empty()) {
    task(0);
    return;
  }
  task_ = &task;
  begin_.arrive_and_wait();
  task(0);
  end_.arrive_and_wait();
}

void ThreadPool::work(int thread) {
  while (true) {
    begin_.arrive_and_wait();
    if (!task_) return;
    (*task_)(thread);
    end_.arrive_and_wait();
  }
}

}  // namespace trajan
