#include "server/store_findings.h"

#include <algorithm>
#include <cmath>

#include "server/scene_digest.h"
#include "server/store_jobs.h"

namespace trajan::store {

namespace {

void keep(Database& database, std::int64_t job, const v1::Finding& finding) {
  Statement insert = database.prepare(
      "INSERT OR REPLACE INTO findings(job_id, measure, family, machine, finding) VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, job)
      .bind(2, finding.measure())
      .bind(3, finding.family())
      .bind(4, finding.cost().machine())
      .bind_blob(5, finding.SerializeAsString())
      .run();
}

/// Of the job that computed the run.
std::int64_t computed_by(const v1::Run& run) {
  return job_number(run.answered_by().empty() ? run.job_id() : run.answered_by());
}

std::optional<v1::Finding> find(Database& database, std::int64_t job, const std::string& measure) {
  Statement query = database.prepare("SELECT finding FROM findings WHERE job_id = ? AND measure = ?");
  if (!query.bind(1, job).bind(2, measure).step()) return std::nullopt;
  v1::Finding finding;
  finding.ParseFromString(query.text(0));
  return finding;
}

/// Every level's distance from the extrapolated value, and the finest level's band.
void keep_convergence(Database& database, const v1::Study& study, const v1::Convergence& convergence) {
  if (!convergence.has_band()) return;
  const double scale = convergence.extrapolated() == 0 ? 1 : std::abs(convergence.extrapolated());
  for (int level = 0; level < study.runs_size(); ++level) {
    const std::int64_t job = computed_by(study.runs(level));
    auto finding = find(database, job, convergence.measure());
    if (!finding) continue;
    const bool finest = level + 1 == study.runs_size();
    if (finest) finding->set_band(convergence.band() / scale);
    if (!finding->has_error() && !finest)
      finding->set_error(std::abs(convergence.values(level) - convergence.extrapolated()) / scale);
    keep(database, job, *finding);
  }
}

}  // namespace

void keep_findings(Database& database, const v1::Job& job) {
  if (job.measures().empty()) return;
  const v1::Scene scene = get_scene(database, job_number(job.job_id()));
  v1::Finding finding;
  // Other analyses of the same question are of its family.
  finding.set_family(
      family_digest(job.parent_id().empty() ? scene : get_scene(database, job_number(job.parent_id()))));
  *finding.mutable_settings() = settings_of(scene);
  *finding.mutable_cost() = job.cost();
  finding.set_solver_version(TRAJAN_VERSION);
  for (const v1::MeasureValue& measure : job.measures()) {
    finding.set_measure(measure.name());
    finding.set_value(measure.value());
    finding.clear_error();
    if (measure.has_error()) finding.set_error(std::abs(measure.error()));
    keep(database, job_number(job.job_id()), finding);
  }
}

void keep_findings(Database& database, const v1::Study& study) {
  for (const v1::Convergence& convergence : study.convergences()) keep_convergence(database, study, convergence);
}

std::vector<v1::Finding> findings(Database& database, const std::string& family, const std::string& machine) {
  Statement query =
      database.prepare("SELECT finding FROM findings WHERE family = ?1 AND (machine = ?2 OR ?2 = '')");
  query.bind(1, family).bind(2, machine);
  std::vector<v1::Finding> found;
  while (query.step()) found.emplace_back().ParseFromString(query.text(0));
  return found;
}

}  // namespace trajan::store
