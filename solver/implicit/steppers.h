#pragma once

#include <memory>

#include "solver/simulation/executor.h"
#include "solver/simulation/stepper.h"

namespace trajan {

/// The one for the model's analysis; nullptr: explicit steps. `resume`: goes on from there.
std::unique_ptr<Stepper> make_stepper(const Model& model, Executor& executor, const Checkpoint* resume = nullptr);

}  // namespace trajan
