#include "server/store_jobs.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "server/errors.h"
#include "server/scene_digest.h"
#include "server/store_answers.h"
#include "server/store_estimates.h"
#include "server/store_requests.h"
#include "server/store_studies.h"

namespace trajan::store {

namespace {

std::optional<std::int64_t> parse_positive(const std::string& text) {
  std::int64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || number < 1) return std::nullopt;
  return number;
}

[[noreturn]] void throw_not_found(const std::string& job_id) {
  throw ServiceError(grpc::StatusCode::NOT_FOUND, "NO_SUCH_JOB", "there is no job \"" + job_id + "\"");
}

/// The bytes of a message that has the scene in its field 2, as both kinds of requests have.
v1::SubmitJobRequest get_request(Database& database, std::int64_t job) {
  Statement query = database.prepare("SELECT request FROM jobs WHERE job_id = ?");
  if (!query.bind(1, job).step()) throw_not_found(std::to_string(job));
  v1::SubmitJobRequest request;
  request.ParseFromString(query.text(0));
  return request;
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

void remove_row(Database& database, std::int64_t job) {
  forget_answer(database, job);
  forget_estimate(database, job);
  database.prepare("DELETE FROM events WHERE job_id = ?").bind(1, job).run();
  database.prepare("DELETE FROM labels WHERE job_id = ?").bind(1, job).run();
  database.prepare("DELETE FROM jobs WHERE job_id = ?").bind(1, job).run();
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
  const NewJob row{request.request_id(), request.priority(),     deterministic_bytes(request),
                   request.labels(),     request.scene().name(), false};
  require_valid(row);
  if (auto before = submitted_before(database, row)) return *before;
  require_room(database, 1);
  v1::Job job = insert_job(database, row);
  *job.mutable_settings() = settings_of(request.scene());
  database.prepare("UPDATE jobs SET scene = ? WHERE job_id = ?")
      .bind(1, scene_digest(request.scene()))
      .bind(2, job_number(job.job_id()))
      .run();
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

std::filesystem::path files_of(const std::filesystem::path& jobs_directory, const v1::Job& job) {
  return jobs_directory / (job.answered_by().empty() ? job.job_id() : job.answered_by());
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
  constexpr int first_label = 6;
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
  sql += request.parent_id().empty() ? " AND (?4 OR parent IS NULL)" : " AND parent = ?5";
  int parameter = first_label;
  for (std::size_t i = 0; i < request.labels().size(); ++i, parameter += 2) {
    sql += " AND EXISTS (SELECT 1 FROM labels WHERE labels.job_id = jobs.job_id AND key = ?" +
           std::to_string(parameter) + " AND value = ?" + std::to_string(parameter + 1) + ")";
  }
  sql += " ORDER BY job_id DESC LIMIT ?3";
  Statement query = database.prepare(sql);
  query.bind(1, *before).bind(2, state_bits(request)).bind(3, page + 1);
  if (request.parent_id().empty()) {
    query.bind(4, request.with_runs() ? 1 : 0);
  } else {
    query.bind(5, job_number(request.parent_id()));
  }
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

std::vector<std::int64_t> remove_job(Database& database, std::int64_t number) {
  const v1::Job job = get_job(database, number);
  if (!job.parent_id().empty()) {
    throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "RUN_OF_STUDY",
                       "job " + job.job_id() + " is a run of study " + job.parent_id() + "; remove that");
  }
  if (!has_ended(job.state())) {
    throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "NOT_ENDED",
                       "job " + job.job_id() + " has not ended; cancel it first");
  }
  std::vector<std::int64_t> removed = runs_of(database, number);
  removed.push_back(number);
  for (const std::int64_t each : removed) remove_row(database, each);
  return removed;
}

v1::Job cancel(Database& database, std::int64_t number, const std::string& reason) {
  v1::Job job = get_job(database, number);
  if (job.state() != v1::QUEUED && job.state() != v1::RUNNING) return job;
  if (!reason.empty()) append_message(database, job, "asked to cancel: " + reason);
  const bool ends_at_once = job.state() == v1::QUEUED && !job.has_study();
  enter(database, job, ends_at_once ? v1::CANCELLED : v1::CANCELLING);
  update(database, job);
  for (const std::int64_t run : runs_of(database, number)) cancel(database, run, "");
  if (job.has_study()) follow_runs(database, number);
  return get_job(database, number);
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

void add_warnings(Database& database, v1::Job& job,
                  const google::protobuf::RepeatedPtrField<v1::Warning>& warnings) {
  for (const v1::Warning& warning : warnings) {
    const auto is_same = [&](const v1::Warning& known) { return known.name() == warning.name(); };
    if (std::ranges::any_of(job.warnings(), is_same)) continue;
    *job.add_warnings() = warning;
    std::ostringstream text;
    text << "warning: the result is doubtful from time " << warning.time() << " on: " << warning.cause() << "; "
         << warning.remedy();
    append_message(database, job, text.str());
  }
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
  database.prepare("UPDATE jobs SET state = ?, job = ? WHERE job_id = ?")
      .bind(1, job.state())
      .bind_blob(2, job.SerializeAsString())
      .bind(3, job_number(job.job_id()))
      .run();
  if (!job.parent_id().empty()) follow_runs(database, job_number(job.parent_id()));
}

}  // namespace trajan::store
