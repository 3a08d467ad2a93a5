#pragma once

#include <Eigen/Core>
#include <string>

#include "solver/implicit/discretization.h"

namespace trajan {

/// Where a vector of nodes is largest among the particles, in words: 'body "beam" near (1, 0.5)'.
std::string largest_place(const Model& model, const Discretization& on, const Eigen::VectorXd& values);

}  // namespace trajan
