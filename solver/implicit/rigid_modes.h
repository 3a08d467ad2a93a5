#pragma once

#include <string>

#include "solver/implicit/constraints.h"

namespace trajan {

/// Which bodies can move or turn as rigid ones without resistance, and how, in words: 'body "beam" can turn freely
/// about (0, 0.5)'; empty: none can. Bodies that share nodes move as one.
std::string find_free_motion(const Model& model, const Discretization& on, const Constraints& constraints);

}  // namespace trajan
