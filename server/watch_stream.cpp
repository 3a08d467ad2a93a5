#include "server/watch_stream.h"

#include <chrono>
#include <deque>

#include "server/store_jobs.h"

namespace trajan {

namespace {

class WatchStream final : public Stream<v1::WatchJobResponse> {
 public:
  WatchStream(grpc::CallbackServerContext* context, const v1::WatchJobRequest& request, std::int64_t job,
              store::Store& store, Hub& hub, TaskQueue& queue)
      : Stream(context, job, hub, queue), store_(store), cursor_(request.after_sequence()) {}

 private:
  Next next(v1::WatchJobResponse& response) final {
    if (done_) return Next::finish;
    if (!begun_) return begin(response);
    if (!events_.empty()) return write_event(response);
    v1::Job job = read_job();
    if (cursor_ < job.last_sequence()) {
      read_events();
      return write_event(response);
    }
    done_ = store::has_ended(job.state());
    if (!done_) return heartbeat_if_due(response);
    *response.mutable_job() = std::move(job);
    return write();
  }

  Next begin(v1::WatchJobResponse& response) {
    v1::Job job = read_job();
    if (cursor_ < 0 || cursor_ > job.last_sequence()) {
      throw ServiceError(grpc::StatusCode::OUT_OF_RANGE, "AFTER_SEQUENCE",
                         "the last event of job " + job.job_id() + " has the sequence number " +
                             std::to_string(job.last_sequence()));
    }
    begun_ = true;
    done_ = store::has_ended(job.state()) && cursor_ == job.last_sequence();
    *response.mutable_job() = std::move(job);
    return write();
  }

  Next write_event(v1::WatchJobResponse& response) {
    cursor_ = events_.front().sequence();
    *response.mutable_event() = std::move(events_.front());
    events_.pop_front();
    return write();
  }

  Next heartbeat_if_due(v1::WatchJobResponse& response) {
    constexpr auto quiet = std::chrono::seconds(4);
    if (std::chrono::steady_clock::now() - last_write_ < quiet) return Next::wait;
    response.mutable_heartbeat();
    return write();
  }

  Next write() {
    last_write_ = std::chrono::steady_clock::now();
    return Next::write;
  }

  v1::Job read_job() {
    return store_.read([&](store::Database& database) { return store::get_job(database, job()); });
  }

  void read_events() {
    constexpr int most = 64;
    const auto events = store_.read(
        [&](store::Database& database) { return store::events_after(database, job(), cursor_, most); });
    events_.assign(events.begin(), events.end());
  }

  store::Store& store_;
  std::int64_t cursor_;
  std::deque<v1::Event> events_;  ///< read ahead, at most one page
  std::chrono::steady_clock::time_point last_write_;
  bool begun_ = false;
  bool done_ = false;
};

}  // namespace

grpc::ServerWriteReactor<v1::WatchJobResponse>* watch_job(grpc::CallbackServerContext* context,
                                                          const v1::WatchJobRequest& request, store::Store& store,
                                                          Hub& hub, TaskQueue& queue) {
  const std::int64_t job = store::job_number(request.job_id());
  return Stream<v1::WatchJobResponse>::start(
      std::make_shared<WatchStream>(context, request, job, store, hub, queue));
}

}  // namespace trajan
