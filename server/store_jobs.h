#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "server/store_database.h"
#include "trajan/v1/jobs.pb.h"

/// Jobs and their event logs as rows. What changes something must run inside Store::commit. Functions
/// that are given a job's number throw ServiceError NOT_FOUND if there is no such job.
namespace trajan::store {

/// True for states that a job never leaves.
bool has_ended(v1::JobState state);

/// The number in a job_id. Throws ServiceError NOT_FOUND for a text that cannot be one.
std::int64_t job_number(const std::string& job_id);

/// Jobs that may wait at most.
inline constexpr std::int64_t queue_limit = 10'000;

/// Queues the request, whose scene must be valid, or finds the job that an equal request with the same
/// request_id made. Throws ServiceError INVALID_ARGUMENT for what is out of range beside the scene,
/// ALREADY_EXISTS for another request with that request_id, RESOURCE_EXHAUSTED if the queue is full.
v1::Job submit(Database& database, const v1::SubmitJobRequest& request);

v1::Job get_job(Database& database, std::int64_t job);
/// The folder of its files among those of all jobs: its own, or that of the job whose answer it took over.
std::filesystem::path files_of(const std::filesystem::path& jobs_directory, const v1::Job& job);
v1::Scene get_scene(Database& database, std::int64_t job);
bool exists(Database& database, std::int64_t job);

/// Throws ServiceError INVALID_ARGUMENT for a page token, a page size or labels that are not allowed.
v1::ListJobsResponse list_jobs(Database& database, const v1::ListJobsRequest& request);

/// At most `limit` events after the one numbered `sequence`, in order.
std::vector<v1::Event> events_after(Database& database, std::int64_t job, std::int64_t sequence, int limit);

/// Forgets an ended job, a study with its runs; returns the numbers of all that were removed. Throws
/// ServiceError FAILED_PRECONDITION if it has not ended, or if it is a run of a study.
std::vector<std::int64_t> remove_job(Database& database, std::int64_t job);

/// A queued job is cancelled, a running one CANCELLING, any other left as it is; so are all runs of a study.
v1::Job cancel(Database& database, std::int64_t job, const std::string& reason);

// What the functions above and the leases (store_leases.h) are made of.

/// Numbers the event, stamps it with the time and appends it. Changes only `job`, not its row.
void append_event(Database& database, v1::Job& job, v1::Event event);
void append_message(Database& database, v1::Job& job, const std::string& message);
/// Gives the job those that it does not have yet, each with a message. Changes only `job`, not its row.
void add_warnings(Database& database, v1::Job& job,
                  const google::protobuf::RepeatedPtrField<v1::Warning>& warnings);
/// Sets the state, with `started` and `ended`, and appends the event. Changes only `job`, not its row.
void enter(Database& database, v1::Job& job, v1::JobState state);
/// Writes `job` into its row; the study that it is a run of follows.
void update(Database& database, const v1::Job& job);

}  // namespace trajan::store
