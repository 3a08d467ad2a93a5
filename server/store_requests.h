#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "server/store_database.h"
#include "trajan/v1/jobs.pb.h"

/// What submitting a job and submitting a study have in common. Changes must run inside Store::commit.
namespace trajan::store {

using Labels = google::protobuf::Map<std::string, std::string>;

/// A row to be inserted into the table of jobs.
struct NewJob {
  std::string request_id;
  int priority = 0;
  std::string bytes;  ///< of the request
  Labels labels;
  std::string scene_name;
  bool is_study = false;
};

/// Throws ServiceError INVALID_ARGUMENT.
void require_few_labels(const Labels& labels);
/// Throws ServiceError INVALID_ARGUMENT for labels, a priority or a request id that are not allowed.
void require_valid(const NewJob& request);

/// The job that an equal request with the same request_id made. Throws ServiceError ALREADY_EXISTS if the
/// request was another one.
std::optional<v1::Job> submitted_before(Database& database, const NewJob& request);

/// Throws ServiceError RESOURCE_EXHAUSTED if the queue has no room for `count` more jobs.
void require_room(Database& database, std::int64_t count);

/// Inserts the row and its labels and queues it. The returned job is not yet in its row.
v1::Job insert_job(Database& database, const NewJob& request);

}  // namespace trajan::store
