#include "server/estimator.h"

#include "server/estimate_errors.h"
#include "server/run_cost.h"
#include "server/scene_digest.h"
#include "server/store_estimates.h"
#include "server/store_findings.h"

namespace trajan {

namespace {

/// Predictions that are looked at, of a family and of all jobs.
constexpr int most_of_family = 100, most_recent = 200;

}  // namespace

Estimator::Estimator(store::Store& store, Measurer& measurer, int workers, int threads)
    : store_(store), measurer_(measurer), machine_(machine_name()), workers_(workers), threads_(threads) {}

Evidence Estimator::evidence(const v1::Scene& scene, int priority) const {
  const std::string family = family_digest(scene);
  Evidence evidence = store_.read([&](store::Database& database) {
    Evidence known;
    known.calibration = store::find_calibration(database, machine_);
    known.family = store::predictions(database, family, most_of_family);
    known.recent = store::predictions(database, "", most_recent);
    known.findings = store::findings(database, family, machine_);
    known.queue_seconds = store::queue_seconds(database, priority, workers_);
    return known;
  });
  evidence.machine = machine_;
  evidence.threads = threads_;
  return evidence;
}

v1::Estimate Estimator::estimate(const v1::Scene& scene, const Model& model, int priority) const {
  return trajan::estimate(scene, model, evidence(scene, priority));
}

v1::Estimate Estimator::estimate_in_full(const v1::Scene& scene, const Model& model, int priority,
                                         double probe_seconds) const {
  Evidence known = evidence(scene, priority);
  if (probe_seconds > 0) known.trial = measurer_.try_scene(scene, probe_seconds, threads_of(model, threads_));
  v1::Estimate estimate = trajan::estimate(scene, model, known);
  name_neighbours(scene, known, estimate);
  return estimate;
}

}  // namespace trajan
