#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace trajan::client {

/// Turns Ctrl-C and SIGTERM into a call on a thread of its own while it lives. Make it before the first
/// thread of the process (gRPC starts some), because threads inherit what signals they take. A second
/// signal ends the process at once.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool interrupted() const { return interrupted_; }
  /// What was to stop has stopped, and something is left to do: interrupted() is false from now on. The
  /// next signal still ends the process at once.
  void acknowledge() { interrupted_ = false; }
  /// What happens next time; called at once if it has happened already.
  void on_interrupt(std::function<void()> reaction);

 private:
  void listen();

  int signals_ = -1;
  int stop_ = -1;
  std::atomic<bool> interrupted_ = false;
  bool signalled_ = false;  ///< ever
  std::mutex mutex_;
  std::function<void()> reaction_;
  std::thread thread_;
};

/// While it lives, an interrupt calls `reaction`. `watch` may be null: then nothing happens.
class InterruptReaction {
 public:
  InterruptReaction(InterruptWatch* watch, std::function<void()> reaction) : watch_(watch) {
    if (watch_ != nullptr) watch_->on_interrupt(std::move(reaction));
  }
  ~InterruptReaction() {
    if (watch_ != nullptr) watch_->on_interrupt(nullptr);
  }
  InterruptReaction(const InterruptReaction&) = delete;
  InterruptReaction& operator=(const InterruptReaction&) = delete;

 private:
  InterruptWatch* watch_;
};

}  // namespace trajan::client
