#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace trajan {

/// The server's own warm workers: processes of this very program on this machine. They outlive a crash
/// of the server; the next one adopts those that hold a lease, and counts them. Any thread may call.
class WorkerPool {
 public:
  using Clock = std::chrono::steady_clock;
  /// Gets a worker that is gone, and how it ended. Called by `tick` without locks.
  using Lost = std::function<void(const std::string& worker, const std::string& how)>;

  /// Keeps `size` workers alive, each started as `<command> --worker-id <id>`.
  WorkerPool(int size, Lost lost);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// A worker of an earlier server. False if no such process lives.
  bool adopt(const std::string& worker, pid_t process);
  /// From now on workers are started (by `tick`).
  void start(std::vector<std::string> command);
  /// Notices workers that ended, and starts others in their place: at once at first, later with growing
  /// pauses if they keep ending soon after their start.
  void tick(Clock::time_point now);
  /// True for a living worker of this pool.
  bool owns(const std::string& worker) const;
  /// Ends a worker by force; `tick` will notice.
  void kill(const std::string& worker);
  /// Starts no more workers and sends this signal to those that live.
  void stop(int signal);
  std::size_t alive() const;

 private:
  struct Process {
    pid_t id = 0;
    bool child = true;
    bool killed = false;
    Clock::time_point started;
  };
  struct Ended {
    std::string worker;
    std::string how;
  };
  std::vector<Ended> remove_ended(Clock::time_point now);
  void start_missing(Clock::time_point now);

  const int size_;
  const Lost lost_;
  mutable std::mutex mutex_;
  std::map<std::string, Process> processes_;
  std::vector<std::string> command_;
  int early_ends_ = 0;
  Clock::time_point next_start_;
};

}  // namespace trajan
