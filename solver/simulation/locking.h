#pragma once

#include <vector>

#include "solver/recorder.h"

namespace trajan {

/// Warns of a body whose volume hardly changes and whose cells share no dilatation: every particle asks for its
/// own volume to stay, which are more conditions than nodes can meet, so that the body moves too little, whatever
/// the steps (Hughes 1980). Known before the first step.
std::vector<Warning> warnings_of_locking(const Model& model);

}  // namespace trajan
