#pragma once

#include <optional>

#include "solver/analyses/run.h"
#include "solver/cost/rates.h"
#include "solver/model/model.h"

namespace trajan {

/// What one step of a model consists of.
struct StepSize {
  double particles = 0;
  /// Occupied tiles of the grid, those that particles only reach counting for less.
  double tiles = 0;
  double layer = 0;           ///< particles of a layer, along which bodies touch
  double formulas = 0;        ///< characters of body forces' formulas, by particles
  double uncached_bytes = 0;  ///< of particles, beyond what the cache of a core holds
  /// To which factorizing the tangent is proportional (solver/implicit/equations.h), unless multigrid solves.
  double factor_work = 0;
  bool multigrid = false;
};
StepSize step_size(const Model& model, const ModelPlan& plan);

/// What a run is expected to take: work counted times rates.
struct RunTime {
  double steps = 0;         ///< of the scheme, or iterations of Newton's method
  double core_seconds = 0;  ///< of all threads
  double wall_seconds = 0;  ///< with waiting for the disk
};

/// Nothing where rates are missing. `threads`: that the run has.
std::optional<RunTime> run_time(const Model& model, const ModelPlan& plan, int threads, const Rates& rates);

/// Bytes that a run adds to its process, at most; `bytes`: of recording, by the names of rates.
std::optional<double> run_memory(const Model& model, const ModelPlan& plan, const Rates& bytes);

/// Of the arrays that are held while a run goes on, those that wait to be written among them.
double array_bytes(const Model& model, const ModelPlan& plan);

/// Of a snapshot in the result file, without what all snapshots share.
double snapshot_bytes(const Model& model);

/// An iteration of Newton's method; nothing where rates are missing.
std::optional<double> iteration_seconds(const Model& model, const StepSize& size, const Rates& rates);

}  // namespace trajan
