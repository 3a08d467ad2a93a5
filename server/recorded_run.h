#pragma once

#include <filesystem>
#include <functional>

#include "server/run_cost.h"
#include "solver/analyses/run.h"

namespace trajan {

struct RecordedRun {
  v1::Cost cost;
  RunResult result;
};

/// Asked as a `StopRequest` is, with what was spent so far.
using CostlyStop = std::function<bool(const RunProgress&, const RunCost&)>;

/// Does what a worker does with a job, in a directory that is removed again. Throws InvalidScene.
RecordedRun record_run(const Scene& scene, const std::filesystem::path& directory, int threads,
                       const CostlyStop& stop);

}  // namespace trajan
