#include "server/store_estimates.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>

#include "server/scene_digest.h"
#include "server/store_jobs.h"
#include "solver/cost/rates.h"

namespace trajan::store {

namespace {

v1::Prediction read_prediction(const Statement& query, int column) {
  v1::Prediction prediction;
  prediction.ParseFromString(query.text(column));
  return prediction;
}

/// Of the rates that it holds: those of one version of the solver, and of what is measured.
std::string calibrated_version(const std::string& solver_version) {
  return solver_version + ", rates " + std::to_string(rates_version);
}

/// Of a job that runs or waits.
double seconds_left(const v1::Job& job, const v1::Prediction& prediction) {
  using google::protobuf::util::TimeUtil;
  if (job.progress().has_remaining()) return static_cast<double>(job.progress().remaining().seconds());
  const double whole = prediction.estimate().wall_seconds().value();
  if (job.state() == v1::QUEUED) return whole;
  const auto since = TimeUtil::GetCurrentTime() - job.started();
  return std::max(0.0, whole - 1e-3 * static_cast<double>(TimeUtil::DurationToMilliseconds(since)));
}

}  // namespace

void keep_estimate(Database& database, const std::string& job_id, const v1::Scene& scene,
                   const v1::Estimate& estimate) {
  v1::Prediction prediction;
  prediction.set_job_id(job_id);
  prediction.set_scene_name(scene.name());
  prediction.set_family(family_digest(scene));
  *prediction.mutable_settings() = settings_of(scene);
  *prediction.mutable_estimate() = estimate;
  prediction.set_solver_version(TRAJAN_VERSION);
  database.prepare("INSERT OR IGNORE INTO predictions(job_id, family, ended, prediction) VALUES (?, ?, 0, ?)")
      .bind(1, job_number(job_id))
      .bind(2, prediction.family())
      .bind_blob(3, prediction.SerializeAsString())
      .run();
}

void keep_actual(Database& database, const v1::Job& job) {
  auto prediction = find_prediction(database, job_number(job.job_id()));
  if (!prediction) return;
  *prediction->mutable_cost() = job.cost();
  prediction->set_steps(job.progress().step());
  prediction->set_result_bytes(job.result().size());
  database.prepare("UPDATE predictions SET ended = 1, prediction = ? WHERE job_id = ?")
      .bind_blob(1, prediction->SerializeAsString())
      .bind(2, job_number(job.job_id()))
      .run();
}

void forget_estimate(Database& database, std::int64_t job) {
  database.prepare("DELETE FROM predictions WHERE job_id = ? AND ended = 0").bind(1, job).run();
}

std::optional<v1::Prediction> find_prediction(Database& database, std::int64_t job) {
  Statement query = database.prepare("SELECT prediction FROM predictions WHERE job_id = ?");
  if (!query.bind(1, job).step()) return std::nullopt;
  return read_prediction(query, 0);
}

std::vector<v1::Prediction> predictions(Database& database, const std::string& family, int most) {
  Statement query = database.prepare(
      "SELECT prediction FROM predictions WHERE ended = 1 AND (family = ?1 OR ?1 = '') "
      "ORDER BY job_id DESC LIMIT ?2");
  query.bind(1, family).bind(2, most);
  std::vector<v1::Prediction> found;
  while (query.step()) found.push_back(read_prediction(query, 0));
  return found;
}

void keep_calibration(Database& database, const v1::Calibration& calibration) {
  database.prepare("INSERT OR REPLACE INTO calibrations(machine, version, calibration) VALUES (?, ?, ?)")
      .bind(1, calibration.machine())
      .bind(2, calibrated_version(calibration.solver_version()))
      .bind_blob(3, calibration.SerializeAsString())
      .run();
}

std::optional<v1::Calibration> find_calibration(Database& database, const std::string& machine) {
  Statement query = database.prepare("SELECT calibration FROM calibrations WHERE machine = ? AND version = ?");
  if (!query.bind(1, machine).bind(2, calibrated_version(TRAJAN_VERSION)).step()) return std::nullopt;
  v1::Calibration calibration;
  calibration.ParseFromString(query.text(0));
  return calibration;
}

double queue_seconds(Database& database, int priority, int workers) {
  Statement query = database.prepare(
      "SELECT job, prediction FROM jobs LEFT JOIN predictions USING (job_id) "
      "WHERE is_study = 0 AND (state IN (2, 3) OR (state = 1 AND priority >= ?))");
  query.bind(1, priority);
  double seconds = 0;
  int jobs = 0;
  while (query.step()) {
    v1::Job job;
    job.ParseFromString(query.text(0));
    seconds += seconds_left(job, read_prediction(query, 1));
    ++jobs;
  }
  return jobs < workers ? 0 : seconds / std::max(workers, 1);
}

}  // namespace trajan::store
