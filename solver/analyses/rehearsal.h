#pragma once

#include "solver/analyses/run.h"

namespace trajan {

/// Finds out what the model's executor would hold and do, by letting it take steps without particles: attributes,
/// sweeps, tiles, and the bytes of particles and grid.
void rehearse(const Model& model, ModelPlan& plan);

}  // namespace trajan
