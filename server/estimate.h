#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/model/model.h"
#include "trajan/v1/estimates.pb.h"
#include "trajan/v1/studies.pb.h"

namespace trajan {

/// What is known when a scene is estimated.
struct Evidence {
  std::optional<v1::Calibration> calibration;  ///< of this machine
  std::vector<v1::Prediction> family;          ///< of the scene's family, with what they took, newest first
  std::vector<v1::Prediction> recent;          ///< of any, likewise
  std::vector<v1::Finding> findings;           ///< of the family on this machine
  std::optional<v1::Trial> trial;              ///< of the scene itself
  std::string machine;
  int threads = 1;  ///< of a worker
  double queue_seconds = 0;
};

/// What the scene, whose model it is, would take. Computes from numbers alone.
v1::Estimate estimate(const v1::Scene& scene, const Model& model, const Evidence& evidence);

/// Threads that a job of this model has.
int threads_of(const Model& model, int of_worker);

/// Bytes of the result file: histories with their times, snapshots, and what is stored once of each particle.
std::int64_t result_bytes(const Model& model);

}  // namespace trajan
