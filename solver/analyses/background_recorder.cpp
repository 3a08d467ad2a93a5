#include "solver/analyses/background_recorder.h"

namespace trajan {
namespace {

/// Samples that may wait: more than a disk's slowest answer lets come, few enough to be no matter of memory.
constexpr std::size_t most_tasks = 4096;

}  // namespace

BackgroundRecorder::BackgroundRecorder(Recorder& recorder)
    : recorder_(recorder), durable_rows_(recorder.durable_rows()), thread_([this] { work(); }) {}

BackgroundRecorder::~BackgroundRecorder() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundRecorder::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return closing_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    const bool dead = error_ != nullptr;
    const Task& task = tasks_.front();  // stays where it is while others are appended
    lock.unlock();
    std::exception_ptr error;
    std::int64_t rows = 0;
    try {
      if (!dead) task.store();
      rows = recorder_.durable_rows();
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error) error_ = error;
    if (!error_) durable_rows_ = rows;
    snapshots_ -= task.is_snapshot;
    tasks_.pop_front();
    changed_.notify_all();
  }
}

void BackgroundRecorder::append(Task task) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock,
                [&] { return error_ || (tasks_.size() < most_tasks && !(task.is_snapshot && snapshots_ > 0)); });
  if (error_) std::rethrow_exception(error_);
  snapshots_ += task.is_snapshot;
  tasks_.push_back(std::move(task));
  changed_.notify_all();
}

void BackgroundRecorder::wait_until_stored(std::unique_lock<std::mutex>& lock) {
  changed_.wait(lock, [this] { return tasks_.empty(); });
  if (error_) std::rethrow_exception(error_);
}

void BackgroundRecorder::finish() {
  std::unique_lock lock(mutex_);
  wait_until_stored(lock);
}

void BackgroundRecorder::sample(std::int64_t row, double time, std::span<const double> columns) {
  append({false, [this, row, time, kept = std::vector<double>(columns.begin(), columns.end())] {
            recorder_.sample(row, time, kept);
          }});
}

void BackgroundRecorder::snapshot(std::int64_t row, const Snapshot& snapshot) {
  {
    // The copy is made once there is room for it.
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return error_ || snapshots_ == 0; });
  }
  append({true, [this, row, kept = snapshot] { recorder_.snapshot(row, kept); }});
}

void BackgroundRecorder::checkpoint(const Checkpoint& checkpoint) {
  finish();
  recorder_.checkpoint(checkpoint);
  const std::lock_guard lock(mutex_);
  durable_rows_ = recorder_.durable_rows();
}

void BackgroundRecorder::warn(const Warning& warning) {
  append({false, [this, warning] { recorder_.warn(warning); }});
}

std::int64_t BackgroundRecorder::durable_rows() const {
  const std::lock_guard lock(mutex_);
  return durable_rows_;
}

}  // namespace trajan
