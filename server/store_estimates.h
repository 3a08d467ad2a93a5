#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/store_database.h"
#include "trajan/v1/estimates.pb.h"

/// What jobs were expected to take, what they took, and what this machine is able to do. Predictions of jobs that
/// have succeeded are kept when the jobs are removed. Changes must run inside Store::commit.
namespace trajan::store {

/// A job as it was submitted. No effect if there is a prediction already.
void keep_estimate(Database& database, const std::string& job_id, const v1::Scene& scene,
                   const v1::Estimate& estimate);

/// What a job that has been computed to its end took.
void keep_actual(Database& database, const v1::Job& job);

/// Of a job that is removed: what is not known to be right or wrong.
void forget_estimate(Database& database, std::int64_t job);

std::optional<v1::Prediction> find_prediction(Database& database, std::int64_t job);

/// Of jobs that have succeeded, newest first: of a family (see server/scene_digest.h), or of all if that is empty.
std::vector<v1::Prediction> predictions(Database& database, const std::string& family, int most);

void keep_calibration(Database& database, const v1::Calibration& calibration);
/// Of a machine (see Cost) by this version of the solver.
std::optional<v1::Calibration> find_calibration(Database& database, const std::string& machine);

/// Seconds of wall time until one of so many workers is free for a job of this priority, if it were submitted now
/// and all estimates were right. Jobs without an estimate count nothing.
double queue_seconds(Database& database, int priority, int workers);

}  // namespace trajan::store
