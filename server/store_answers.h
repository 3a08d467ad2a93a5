#pragma once

#include <cstdint>

#include "server/store_database.h"
#include "trajan/v1/jobs.pb.h"

/// Equal scenes are not computed twice: a run of a study takes over the answer of a job that has the same digest,
/// which may be finished, or finish later. Files stay where they are. Changes must run inside Store::commit.
namespace trajan::store {

/// Ends the queued job with the answer of a finished one with the same digest, if there is one and the job may.
void take_over_answer(Database& database, std::int64_t job);

/// Gives the answer of a job that has just succeeded to all that wait for it.
void answer_equal_scenes(Database& database, const v1::Job& job);

/// The job's files go: what took over its answer keeps the numbers only.
void forget_answer(Database& database, std::int64_t job);

}  // namespace trajan::store
