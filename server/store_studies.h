#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/store_database.h"
#include "trajan/v1/estimates.pb.h"
#include "trajan/v1/studies.pb.h"

/// Studies and their runs as rows of the table of jobs. What changes something must run inside Store::commit.
namespace trajan::store {

/// A run to be queued: its settings and its scene, which must be valid.
struct PlannedRun {
  v1::Run run;
  v1::Scene scene;
  v1::Estimate estimate = {};
};

struct StudyPlan {
  std::string kind;  ///< "sweep", "ladder", "tradeoff" or "target"
  v1::Study study;   ///< what is known before anything has run: dials, combinations that were left out
  std::vector<PlannedRun> runs;
};

/// Queues a study and all of its runs, or finds the study that an equal request with the same request_id made.
/// Throws ServiceError as `submit` does.
v1::Job submit_study(Database& database, const v1::SubmitStudyRequest& request, const StudyPlan& plan);

/// Queues a target, which has no runs yet, in the same manner.
v1::Job submit_target(Database& database, const v1::SubmitJobRequest& request, const StudyPlan& plan);

/// Adds a run to a target that has so many, with a message about those. No effect if it has more, or goes no
/// further.
void add_run(Database& database, std::int64_t study, const PlannedRun& run, int runs_before,
             const std::string& message);

/// Ends a target: SUCCEEDED with its run's answer, or FAILED with the message. No effect if it goes no further.
void conclude(Database& database, std::int64_t study, const std::optional<v1::Answer>& answer,
              const std::string& message);

/// What was planned with what the runs have given so far, and what follows from it. Throws ServiceError NOT_FOUND,
/// or FAILED_PRECONDITION if the job is not a study.
v1::Study get_study(Database& database, std::int64_t study);

/// The numbers of a study's runs in their order; none if it is not a study.
std::vector<std::int64_t> runs_of(Database& database, std::int64_t study);

/// Those that have not ended.
std::vector<std::int64_t> open_studies(Database& database);

/// A run of the study changed: brings the study's own state and progress up to date, and keeps its findings when
/// it ends.
void follow_runs(Database& database, std::int64_t study);

}  // namespace trajan::store
