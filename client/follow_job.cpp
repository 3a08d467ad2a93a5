#include "client/follow_job.h"

namespace trajan::client {
namespace {

/// What is known of a job between connections.
struct Followed {
  v1::Job job;
  std::int64_t sequence = 0;
  std::chrono::steady_clock::time_point last_heard = std::chrono::steady_clock::now();
};

void take(const v1::WatchJobResponse& response, Followed& followed, JobListener& listener) {
  followed.last_heard = std::chrono::steady_clock::now();
  if (response.has_job()) {
    followed.job = response.job();
    listener.job(response.job());
  } else if (response.has_event() && response.event().sequence() > followed.sequence) {
    followed.sequence = response.event().sequence();
    if (response.event().has_state()) followed.job.set_state(response.event().state());
    listener.event(response.event());
  }
}

/// One connection: until the server ends it, it is lost, or an interrupt ends it.
void watch_once(Connection& connection, const std::string& job_id, InterruptWatch& interrupt, Followed& followed,
                JobListener& listener) {
  grpc::ClientContext context;
  v1::WatchJobRequest request;
  request.set_job_id(job_id);
  request.set_after_sequence(followed.sequence);
  const auto reader = connection.jobs().WatchJob(&context, request);
  const InterruptReaction reaction(&interrupt, [&context] { context.TryCancel(); });
  v1::WatchJobResponse response;
  while (reader->Read(&response)) take(response, followed, listener);
  const grpc::Status status = reader->Finish();
  const bool again =
      may_come_back(status) && std::chrono::steady_clock::now() - followed.last_heard < silence_allowed;
  if (!again && !interrupt.interrupted()) require_ok(status, context, connection.address());
}

}  // namespace

bool has_ended(v1::JobState state) {
  return state == v1::SUCCEEDED || state == v1::FAILED || state == v1::CANCELLED;
}

v1::Job follow_job(Connection& connection, const std::string& job_id, std::int64_t after_sequence,
                   InterruptWatch& interrupt, JobListener& listener) {
  Followed followed;
  followed.sequence = after_sequence;
  for (Backoff backoff;; backoff.pause()) {
    const auto heard_before = followed.last_heard;
    watch_once(connection, job_id, interrupt, followed, listener);
    // The last message of a stream that went to its end is the job in its terminal state.
    if (interrupt.interrupted() || has_ended(followed.job.state())) break;
    if (followed.last_heard != heard_before) backoff.reset();
    listener.connection_lost();
  }
  if (!interrupt.interrupted()) {
    v1::GetJobRequest request;
    request.set_job_id(job_id);
    return connection.call(&v1::Jobs::Stub::GetJob, request);
  }
  return followed.job;
}

}  // namespace trajan::client
