#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

#include "solver/recorder.h"

namespace trajan {

/// Lets another recorder store by a thread of its own, in the order of the calls, while the solver goes on. Waits
/// only where it must: for the earlier snapshot before the next one is kept, so that there is memory for one at
/// most, and for everything before a checkpoint. What the other one throws is thrown by one of the next calls;
/// after that nothing is stored any more. The other one must not be used before `finish`.
class BackgroundRecorder : public Recorder {
 public:
  explicit BackgroundRecorder(Recorder& recorder);
  ~BackgroundRecorder() override;

  void sample(std::int64_t row, double time, std::span<const double> columns) override;
  void snapshot(std::int64_t row, const Snapshot& snapshot) override;
  void checkpoint(const Checkpoint& checkpoint) override;
  void warn(const Warning& warning) override;
  std::int64_t durable_rows() const override;
  /// Waits until everything is stored.
  void finish();

 private:
  struct Task {
    bool is_snapshot;
    std::function<void()> store;
  };
  void work();
  /// Appends a task when there is room for it. Throws what an earlier one has thrown.
  void append(Task task);
  void wait_until_stored(std::unique_lock<std::mutex>& lock);

  Recorder& recorder_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> tasks_;  ///< the first one is being done
  std::size_t snapshots_ = 0;
  bool closing_ = false;
  std::exception_ptr error_;
  std::int64_t durable_rows_;
  std::thread thread_;
};

}  // namespace trajan
