#include "server/lease_keeper.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>

#include "server/convert.h"
#include "server/log.h"

namespace trajan {

LeaseKeeper::LeaseKeeper(v1::Workers::StubInterface& server, const v1::LeaseResponse& lease, double grace_seconds,
                         const std::atomic<bool>& leaving)
    : server_(server),
      lease_id_(lease.lease_id()),
      lease_seconds_(lease.duration_seconds()),
      grace_seconds_(grace_seconds),
      leaving_(leaving),
      thread_([this] { speak(); }) {}

LeaseKeeper::~LeaseKeeper() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

bool LeaseKeeper::update(const RunProgress& progress) {
  {
    const std::lock_guard lock(mutex_);
    if (!first_) first_ = progress;
    latest_ = progress;
  }
  return command() != Command::go_on;
}

Command LeaseKeeper::command() const {
  const Command command = command_;
  return command == Command::go_on && leaving_ ? Command::release : command;
}

v1::Progress LeaseKeeper::progress() const {
  const std::lock_guard lock(mutex_);
  if (!latest_) return {};
  v1::Progress progress = to_proto(*latest_);
  const auto done = static_cast<double>(latest_->step - first_->step);
  if (done > 0) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - started_).count();
    const double left = elapsed * static_cast<double>(latest_->total_steps - latest_->step) / done;
    using google::protobuf::util::TimeUtil;
    *progress.mutable_remaining() = TimeUtil::MillisecondsToDuration(static_cast<std::int64_t>(left * 1000));
  }
  return progress;
}

/// Often at first, when people watch; rarely in a long run, whose log would grow without use.
LeaseKeeper::Clock::duration LeaseKeeper::pause() const {
  constexpr double shortest = 0.2;
  constexpr double longest = 2;
  const double elapsed = std::chrono::duration<double>(Clock::now() - started_).count();
  const double pause = std::min(std::clamp(elapsed / 50, shortest, longest), lease_seconds_ / 3);
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(pause));
}

void LeaseKeeper::speak() {
  while (command_ != Command::lost) {
    {
      std::unique_lock lock(mutex_);
      if (wake_.wait_for(lock, pause(), [&] { return closed_; })) return;
    }
    report_once();
  }
}

grpc::Status LeaseKeeper::report(const v1::ReportRequest& request, v1::ReportResponse& response) const {
  grpc::ClientContext context;
  // A server that was away is found again while the call waits for it.
  context.set_wait_for_ready(true);
  context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(5));
  return server_.Report(&context, request, &response);
}

void LeaseKeeper::tell(const v1::Warning& warning) {
  v1::ReportRequest request;
  request.set_lease_id(lease_id_);
  *request.add_warnings() = warning;
  v1::ReportResponse response;
  const grpc::Status status = report(request, response);
  if (!status.ok()) logging::warning("not told", {{"warning", warning.name()}, {"error", status.error_message()}});
}

void LeaseKeeper::report_once() {
  v1::ReportRequest request;
  request.set_lease_id(lease_id_);
  v1::Progress latest = progress();
  if (latest.total_steps() > 0) *request.mutable_progress() = std::move(latest);
  v1::ReportResponse response;
  const grpc::Status status = report(request, response);
  if (status.ok()) {
    server_seen_ = Clock::now();
    if (response.cancel()) command_ = Command::cancel;
    if (response.release() && !response.cancel()) command_ = Command::release;
  } else if (status.error_code() == grpc::StatusCode::NOT_FOUND) {
    logging::warning("lease lost", {{"lease", lease_id_}});
    command_ = Command::lost;
  } else if (Clock::now() - server_seen_ > std::chrono::duration<double>(grace_seconds_)) {
    logging::warning("the server is away for too long", {{"lease", lease_id_}, {"error", status.error_message()}});
    command_ = Command::release;
  }
}

}  // namespace trajan
