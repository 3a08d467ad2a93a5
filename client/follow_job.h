#pragma once

#include <functional>

#include "client/connection.h"
#include "client/interrupt.h"

namespace trajan::client {

/// What happens to a job, as it is told.
class JobListener {
 public:
  virtual ~JobListener() = default;
  /// The state at (re)connection and at the end.
  virtual void job(const v1::Job& job) = 0;
  virtual void event(const v1::Event& event) = 0;
  /// The connection was lost and is sought again.
  virtual void connection_lost() = 0;
};

/// Says nothing.
class QuietListener : public JobListener {
 public:
  void job(const v1::Job&) override {}
  void event(const v1::Event&) override {}
  void connection_lost() override {}
};

bool has_ended(v1::JobState state);

/// Follows a job to its end and returns it, over lost connections and restarts of the server, without
/// missing or repeating an event. If it is interrupted it returns the job as it last was, not ended.
/// Throws CallError if the server stays away for a minute, or refuses.
v1::Job follow_job(Connection& connection, const std::string& job_id, std::int64_t after_sequence,
                   InterruptWatch& interrupt, JobListener& listener);

}  // namespace trajan::client
