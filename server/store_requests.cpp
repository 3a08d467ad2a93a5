#include "server/store_requests.h"

#include <google/protobuf/util/time_util.h>

#include "server/errors.h"
#include "server/store_jobs.h"

namespace trajan::store {

void require_few_labels(const Labels& labels) {
  constexpr std::size_t most_labels = 32;
  if (labels.size() > most_labels) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "LABELS", "at most 32 labels are allowed");
  }
}

void require_valid(const NewJob& request) {
  require_few_labels(request.labels);
  if (request.request_id.size() > 128) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "REQUEST_ID",
                       "request_id is longer than 128 characters");
  }
  if (request.priority < -100 || request.priority > 100) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "PRIORITY", "priority must be -100 to 100");
  }
}

std::optional<v1::Job> submitted_before(Database& database, const NewJob& request) {
  if (request.request_id.empty()) return std::nullopt;
  Statement query = database.prepare("SELECT job, request FROM jobs WHERE request_id = ?");
  if (!query.bind(1, request.request_id).step()) return std::nullopt;
  if (query.text(1) != request.bytes) {
    throw ServiceError(grpc::StatusCode::ALREADY_EXISTS, "REQUEST_ID_IN_USE",
                       "request_id \"" + request.request_id + "\" was used for another request; choose a new one");
  }
  v1::Job job;
  job.ParseFromString(query.text(0));
  return job;
}

void require_room(Database& database, std::int64_t count) {
  Statement query = database.prepare("SELECT 1 FROM jobs WHERE state = 1 AND is_study = 0 LIMIT 1 OFFSET ?");
  if (query.bind(1, queue_limit - count).step()) {
    throw ServiceError(grpc::StatusCode::RESOURCE_EXHAUSTED, "QUEUE_FULL",
                       "more than " + std::to_string(queue_limit) + " jobs would wait; try again later");
  }
}

v1::Job insert_job(Database& database, const NewJob& request) {
  Statement insert = database.prepare(
      "INSERT INTO jobs(state, priority, losses, process_id, request_id, job, request, is_study) "
      "VALUES (1, ?, 0, 0, ?, x'', ?, ?)");
  insert.bind(1, request.priority).bind_blob(3, request.bytes).bind(4, request.is_study ? 1 : 0);
  if (request.request_id.empty()) {
    insert.bind_null(2);
  } else {
    insert.bind(2, request.request_id);
  }
  insert.run();
  v1::Job job;
  job.set_job_id(std::to_string(database.last_insert_id()));
  job.set_scene_name(request.scene_name);
  *job.mutable_labels() = request.labels;
  job.set_priority(request.priority);
  *job.mutable_submitted() = google::protobuf::util::TimeUtil::GetCurrentTime();
  for (const auto& [key, value] : request.labels) {
    Statement label = database.prepare("INSERT INTO labels(key, value, job_id) VALUES (?, ?, ?)");
    label.bind(1, key).bind(2, value).bind(3, job_number(job.job_id())).run();
  }
  enter(database, job, v1::QUEUED);
  return job;
}

}  // namespace trajan::store
