#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "solver/model/model.h"
#include "solver/recorder.h"

namespace trajan {

struct RunProgress {
  std::int64_t step = 0;
  std::int64_t total_steps = 0;  ///< estimated from the present time step
  double time = 0;
  double end_time = 0;
  std::int64_t rows = 0;  ///< durable rows of histories
  double energy_balance_error = 0;
  double particle_steps_per_second = 0;
};

struct RunOptions {
  int threads = 1;
  double checkpoint_interval = 10;   ///< seconds of wall time; <= 0: after every sample
  std::optional<Checkpoint> resume;  ///< goes on from here
};

enum class RunEnd { finished, stopped, diverged };

struct RunResult {
  RunEnd end = RunEnd::finished;
  std::optional<Divergence> divergence;
  std::vector<Warning> warnings;  ///< since it was started or resumed, at most `most_warnings`
  RunProgress progress;
};

/// Asked at least every 0.1 s of wall time; true stops the run at once.
using StopRequest = std::function<bool(const RunProgress&)>;

/// Runs the model's analysis to its end. The bits that reach the recorder depend neither on `threads`
/// nor on interruptions in between. Throws only what the recorder throws, and std::bad_alloc.
RunResult run(const Model& model, const RunOptions& options, Recorder& recorder, const StopRequest& stop);

/// Whether the analysis solves systems of equations: all but explicit motions and relaxations do.
bool solves_for_displacements(const Model& model);

/// What will be modelled, for people who plan a run.
struct ModelPlan {
  std::int64_t particles = 0;
  std::int64_t active_cells = 0;
  double time_step = 0;
  std::int64_t steps = 0;
  std::string time_step_limit;
  std::int64_t memory_bytes = 0;
  struct Attribute {
    std::string name;
    int bytes = 0;  ///< per particle or node
    std::string wanted_by;
  };
  std::vector<Attribute> attributes;
  std::vector<Attribute> node_attributes;  ///< "sum.": what particles scatter to the nodes around their tile
  struct BodyStages {
    std::vector<std::string> bodies, stages;  ///< in the order in which stages are done
  };
  /// A sweep over all particles.
  struct Sweep {
    std::vector<BodyStages> of_bodies;
  };
  std::vector<Sweep> sweeps;        ///< of an explicit step; implicit analyses have none
  std::int64_t tiles = 0;           ///< that exist at time 0
  std::int64_t occupied_tiles = 0;  ///< those of them that have particles
  std::int64_t particle_bytes = 0, grid_bytes = 0;
  std::int64_t matrix_bytes = 0;  ///< without factors
};
ModelPlan plan(const Model& model);

}  // namespace trajan
