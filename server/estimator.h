#pragma once

#include "server/estimate.h"
#include "server/measurer.h"
#include "server/store.h"

namespace trajan {

/// Estimates scenes from what the store knows. Any thread may call.
class Estimator {
 public:
  /// Of jobs for so many workers with so many threads each.
  Estimator(store::Store& store, Measurer& measurer, int workers, int threads);

  /// Of a valid scene, without a change of the store.
  v1::Estimate estimate(const v1::Scene& scene, const Model& model, int priority) const;
  /// The same with neighbours, and with a trial run if `probe_seconds` is more than 0.
  v1::Estimate estimate_in_full(const v1::Scene& scene, const Model& model, int priority,
                                double probe_seconds) const;

 private:
  Evidence evidence(const v1::Scene& scene, int priority) const;

  store::Store& store_;
  Measurer& measurer_;
  const std::string machine_;
  const int workers_, threads_;
};

}  // namespace trajan
