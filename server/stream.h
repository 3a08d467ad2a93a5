#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <mutex>

#include "server/errors.h"
#include "server/hub.h"
#include "server/status.h"
#include "server/task_queue.h"

namespace trajan {

/// One server-streaming call. It holds one response and a cursor into what is stored, never a queue:
/// while the client does not read, nothing is computed for it. At most one of `next` and one write is
/// under way; `Finish` is called exactly once. A stream owns itself until gRPC is done with it.
template <class Response>
class Stream : public grpc::ServerWriteReactor<Response>,
               public Listener,
               public std::enable_shared_from_this<Stream<Response>> {
 public:
  /// Begins the stream; `next` runs on `queue`, woken by changes of `job`.
  static grpc::ServerWriteReactor<Response>* start(std::shared_ptr<Stream> stream) {
    stream->self_ = stream;
    stream->hub_.subscribe(stream->job_, stream);
    stream->wake();
    return stream.get();
  }

  void wake() final {
    const std::lock_guard lock(mutex_);
    if (state_ == State::idle) {
      post();
    } else {
      woken_ = true;
    }
  }

  void end() final {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    wake();
  }

 protected:
  enum class Next { write, wait, finish };

  Stream(grpc::CallbackServerContext* context, std::int64_t job, Hub& hub, TaskQueue& queue)
      : context_(*context), job_(job), hub_(hub), queue_(queue) {}

  /// Fills the (cleared) response, or says that there is nothing now, or nothing ever. What it throws
  /// ends the call.
  virtual Next next(Response& response) = 0;

  std::int64_t job() const { return job_; }

 private:
  enum class State { idle, busy, writing, finished };

  /// With the lock held.
  void post() {
    state_ = State::busy;
    woken_ = false;
    queue_.post([stream = this->shared_from_this()] { stream->advance(); });
  }

  void advance() {
    Next next_step = Next::finish;
    std::exception_ptr error = why_ended();
    if (!error) {
      try {
        response_.Clear();
        next_step = next(response_);
      } catch (...) {
        error = std::current_exception();
      }
    }
    const std::lock_guard lock(mutex_);
    if (error || next_step == Next::finish) {
      state_ = State::finished;
      this->Finish(to_status(context_, error));
    } else if (next_step == Next::write) {
      state_ = State::writing;
      this->StartWrite(&response_);
    } else if (woken_) {
      post();
    } else {
      state_ = State::idle;
    }
  }

  std::exception_ptr why_ended() {
    const std::lock_guard lock(mutex_);
    if (cancelled_) {
      return std::make_exception_ptr(
          ServiceError(grpc::StatusCode::CANCELLED, "CANCELLED", "the call was cancelled"));
    }
    if (ending_) {
      return std::make_exception_ptr(
          ServiceError(grpc::StatusCode::UNAVAILABLE, "DRAINING", "the server is shutting down; reconnect"));
    }
    return nullptr;
  }

  void OnWriteDone(bool ok) final {
    const std::lock_guard lock(mutex_);
    cancelled_ = cancelled_ || !ok;
    post();
  }

  void OnCancel() final {
    {
      const std::lock_guard lock(mutex_);
      cancelled_ = true;
    }
    wake();
  }

  /// What the stream holds is released where it is used.
  void OnDone() final {
    hub_.unsubscribe(job_, this);
    queue_.post([self = std::move(self_)]() mutable { self.reset(); });
  }

  grpc::CallbackServerContext& context_;
  const std::int64_t job_;
  Hub& hub_;
  TaskQueue& queue_;
  std::mutex mutex_;
  State state_ = State::idle;
  bool woken_ = false;
  bool ending_ = false;
  bool cancelled_ = false;
  Response response_;
  std::shared_ptr<Stream> self_;
};

}  // namespace trajan
