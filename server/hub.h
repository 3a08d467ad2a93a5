#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

namespace trajan {

/// Wants to know that a job changed. Both functions return at once and may be called from any thread,
/// also after unsubscribing.
class Listener {
 public:
  virtual ~Listener() = default;
  /// Something may have changed, or some time has passed.
  virtual void wake() = 0;
  /// The server shuts down.
  virtual void end() = 0;
};

/// Tells listeners that their job changed. It carries no data: what changed is in the store, so that a
/// slow listener costs nothing. Any thread may call.
class Hub {
 public:
  void subscribe(std::int64_t job, std::shared_ptr<Listener> listener);
  void unsubscribe(std::int64_t job, const Listener* listener);
  void publish(std::int64_t job);
  /// Wakes everybody; called now and then for the sake of heartbeats.
  void wake_all();
  /// Ends everybody who listens now or later.
  void end_all();

 private:
  std::mutex mutex_;
  std::multimap<std::int64_t, std::shared_ptr<Listener>> listeners_;
  bool ended_ = false;
};

}  // namespace trajan
