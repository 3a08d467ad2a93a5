#include "server/store_jobs.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <charconv>

#include "server/errors.h"

namespace trajan::store {

namespace {

std::optional<std::int64_t> parse_positive(const std::string& text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number < 1) return std::nullopt;
  return number;
}

/// Equal messages give equal bytes, also if they hold maps.
std::string deterministic_bytes(const google::protobuf::Message& message) {
  std::string bytes;
  {
    google::protobuf::io::StringOutputStream stream(&bytes);
    google::protobuf::io::CodedOutputStream coded(&stream);
    coded.SetSerializationDeterministic(true);
    message.SerializeToCodedStream(&coded);
  }
  return bytes;
}

[[noreturn]] void throw_not_found(const std::string& job_id) {
  throw ServiceError(grpc::StatusCode::NOT_FOUND, "NO_SUCH_JOB", "there is no job \"" + job_id + "\"");
}

v1::SubmitJobRequest get_request(Database& database, std::int64_t job) {
  Statement query = database.prepare("SELECT request FROM jobs WHERE job_id = ?");
  if (!query.bind(1, job).step()) throw_not_found(std::to_string(job));
  v1::SubmitJobRequest request;
  request.ParseFromString(query.text(0));
  return request;
}

/// The job that an earlier request with the same request_id made.
std::optional<v1::Job> submitted_before(Database& database, const std::string& request_id,
                                        const std::string& bytes) {
  if (request_id.empty()) return std::nullopt;
  Statement query = database.prepare("SELECT job, request FROM jobs WHERE request_id = ?");
  if (!query.bind(1, request_id).step()) return std::nullopt;
  if (query.text(1) != bytes) {
    throw ServiceError(grpc::StatusCode::ALREADY_EXISTS, "REQUEST_ID_IN_USE",
                       "request_id \"" + request_id + "\" was used for another request; choose a new one");
  }
  v1::Job job;
  job.ParseFromString(query.text(0));
  return job;
}

void require_room(Database& database) {
  Statement query = database.prepare("SELECT 1 FROM jobs WHERE state = 1 LIMIT 1 OFFSET ?");
  if (query.bind(1, queue_limit - 1).step()) {
    throw ServiceError(grpc::StatusCode::RESOURCE_EXHAUSTED, "QUEUE_FULL",
                       std::to_string(queue_limit) + " jobs are waiting already; try again later");
  }
}

void require_few_labels(const google::protobuf::Map<std::string, std::string>& labels) {
  constexpr std::size_t most_labels = 32;
  if (labels.size() > most_labels) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "LABELS", "at most 32 labels are allowed");
  }
}

void require_valid(const v1::SubmitJobRequest& request) {
  require_few_labels(request.labels());
  if (request.request_id().size() > 128) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "REQUEST_ID",
                       "request_id is longer than 128 characters");
  }
  if (request.priority() < -100 || request.priority() > 100) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "PRIORITY", "priority must be -100 to 100");
  }
}

std::int64_t insert_job(Database& database, const v1::SubmitJobRequest& request, const std::string& bytes) {
  Statement insert = database.prepare(
      "INSERT INTO jobs(state, priority, losses, process_id, request_id, job, request) "
      "VALUES (1, ?, 0, 0, ?, x'', ?)");
  insert.bind(1, request.priority()).bind_blob(3, bytes);
  if (request.request_id().empty()) {
    insert.bind_null(2);
  } else {
    insert.bind(2, request.request_id());
  }
  insert.run();
  return database.last_insert_id();
}

/// Bit s is set if jobs in state s are wanted.
std::int64_t state_bits(const v1::ListJobsRequest& request) {
  if (request.states().empty()) return -1;
  std::int64_t bits = 0;
  for (const int state : request.states()) {
    if (v1::JobState_IsValid(state)) bits |= std::int64_t{1} << state;
  }
  return bits;
}

void insert_labels(Database& database, std::int64_t job, const v1::SubmitJobRequest& request) {
  for (const auto& [key, value] : request.labels()) {
    Statement insert = database.prepare("INSERT INTO labels(key, value, job_id) VALUES (?, ?, ?)");
    insert.bind(1, key).bind(2, value).bind(3, job).run();
  }
}

}  // namespace

bool has_ended(v1::JobState state) {
  return state == v1::SUCCEEDED || state == v1::FAILED || state == v1::CANCELLED;
}

std::int64_t job_number(const std::string& job_id) {
  const auto number = parse_positive(job_id);
  if (!number) throw_not_found(job_id);
  return *number;
}

v1::Job submit(Database& database, const v1::SubmitJobRequest& request) {
  require_valid(request);
  const std::string bytes = deterministic_bytes(request);
  if (auto before = submitted_before(database, request.request_id(), bytes)) return *before;
  require_room(database);
  v1::Job job;
  const std::int64_t number = insert_job(database, request, bytes);
  job.set_job_id(std::to_string(number));
  job.set_scene_name(request.scene().name());
  *job.mutable_labels() = request.labels();
  job.set_priority(request.priority());
  *job.mutable_submitted() = google::protobuf::util::TimeUtil::GetCurrentTime();
  insert_labels(database, number, request);
  enter(database, job, v1::QUEUED);
  update(database, job);
  return job;
}

v1::Job get_job(Database& database, std::int64_t job) {
  Statement query = database.prepare("SELECT job FROM jobs WHERE job_id = ?");
  if (!query.bind(1, job).step()) throw_not_found(std::to_string(job));
  v1::Job found;
  found.ParseFromString(query.text(0));
  return found;
}

v1::Scene get_scene(Database& database, std::int64_t job) {
  return std::move(*get_request(database, job).mutable_scene());
}

bool exists(Database& database, std::int64_t job) {
  return database.prepare("SELECT 1 FROM jobs WHERE job_id = ?").bind(1, job).step();
}

v1::ListJobsResponse list_jobs(Database& database, const v1::ListJobsRequest& request) {
  require_few_labels(request.labels());
  constexpr int default_page = 50;
  constexpr int largest_page = 1000;
  constexpr int first_label = 4;
  if (request.page_size() < 0 || request.page_size() > largest_page) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "PAGE_SIZE", "page_size must be 1 to 1000");
  }
  const auto before =
      request.page_token().empty() ? std::optional(INT64_MAX) : parse_positive(request.page_token());
  if (!before) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "PAGE_TOKEN",
                       "page_token must be a next_page_token of an earlier answer");
  }
  const int page = request.page_size() == 0 ? default_page : request.page_size();
  std::string sql = "SELECT job_id, job FROM jobs WHERE job_id < ?1 AND (?2 >> state) & 1";
  int parameter = first_label;
  for (std::size_t i = 0; i < request.labels().size(); ++i, parameter += 2) {
    sql += " AND EXISTS (SELECT 1 FROM labels WHERE labels.job_id = jobs.job_id AND key = ?" +
           std::to_string(parameter) + " AND value = ?" + std::to_string(parameter + 1) + ")";
  }
  sql += " ORDER BY job_id DESC LIMIT ?3";
  Statement query = database.prepare(sql);
  query.bind(1, *before).bind(2, state_bits(request)).bind(3, page + 1);
  parameter = first_label;
  for (const auto& [key, value] : request.labels()) {
    query.bind(parameter++, key);
    query.bind(parameter++, value);
  }
  v1::ListJobsResponse response;
  while (query.step()) {
    if (response.jobs_size() == page) {
      response.set_next_page_token(response.jobs(page - 1).job_id());
      break;
    }
    response.add_jobs()->ParseFromString(query.text(1));
  }
  return response;
}

std::vector<v1::Event> events_after(Database& database, std::int64_t job, std::int64_t sequence, int limit) {
  Statement query =
      database.prepare("SELECT event FROM events WHERE job_id = ? AND sequence > ? ORDER BY sequence LIMIT ?");
  query.bind(1, job).bind(2, sequence).bind(3, limit);
  std::vector<v1::Event> events;
  while (query.step()) events.emplace_back().ParseFromString(query.text(0));
  return events;
}

void remove_job(Database& database, std::int64_t job) {
  if (!has_ended(get_job(database, job).state())) {
    throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "NOT_ENDED",
                       "job " + std::to_string(job) + " has not ended; cancel it first");
  }
  database.prepare("DELETE FROM events WHERE job_id = ?").bind(1, job).run();
  database.prepare("DELETE FROM labels WHERE job_id = ?").bind(1, job).run();
  database.prepare("DELETE FROM jobs WHERE job_id = ?").bind(1, job).run();
}

v1::Job cancel(Database& database, std::int64_t number, const std::string& reason) {
  v1::Job job = get_job(database, number);
  if (job.state() != v1::QUEUED && job.state() != v1::RUNNING) return job;
  if (!reason.empty()) append_message(database, job, "asked to cancel: " + reason);
  enter(database, job, job.state() == v1::QUEUED ? v1::CANCELLED : v1::CANCELLING);
  update(database, job);
  return job;
}

void append_event(Database& database, v1::Job& job, v1::Event event) {
  job.set_last_sequence(job.last_sequence() + 1);
  event.set_sequence(job.last_sequence());
  *event.mutable_at() = google::protobuf::util::TimeUtil::GetCurrentTime();
  Statement insert = database.prepare("INSERT INTO events(job_id, sequence, event) VALUES (?, ?, ?)");
  insert.bind(1, job_number(job.job_id())).bind(2, event.sequence()).bind_blob(3, event.SerializeAsString()).run();
}

void append_message(Database& database, v1::Job& job, const std::string& message) {
  v1::Event event;
  event.set_message(message);
  append_event(database, job, std::move(event));
}

void enter(Database& database, v1::Job& job, v1::JobState state) {
  using google::protobuf::util::TimeUtil;
  job.set_state(state);
  if (state == v1::RUNNING && !job.has_started()) *job.mutable_started() = TimeUtil::GetCurrentTime();
  if (has_ended(state)) *job.mutable_ended() = TimeUtil::GetCurrentTime();
  v1::Event event;
  event.set_state(state);
  append_event(database, job, std::move(event));
}

void update(Database& database, const v1::Job& job) {
  Statement update = database.prepare("UPDATE jobs SET state = ?, job = ? WHERE job_id = ?");
  update.bind(1, job.state()).bind_blob(2, job.SerializeAsString()).bind(3, job_number(job.job_id())).run();
}

}  // namespace trajan::store
