#pragma once

#include <vector>

#include "solver/recorder.h"

namespace trajan {

/// Warns of conditions on nodes within the domain where B-splines, which take the values of their nodes only at
/// faces of the domain (Steffen, Kirby and Berzins 2008), let the body slip by them. Known before the first step.
std::vector<Warning> warnings_of_soft_supports(const Model& model);

}  // namespace trajan
