#pragma once

#include <Eigen/Core>

#include "solver/implicit/discretization.h"

namespace trajan {

/// Moves particles and surface points by a displacement of the nodes that happens from one time to another.
void move_by(const Eigen::VectorXd& displacement, double from, double to, const Discretization& on,
             const Model& model, Executor& executor);

/// The number of a particle that is not inside the domain, -1: all are.
std::int64_t outside_domain(const Model& model, const Executor& executor);

}  // namespace trajan
