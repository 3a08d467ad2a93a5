#pragma once

#include "trajan/v1/studies.pb.h"

namespace trajan {

/// The dial whose settings are cell sizes, named by their numbers.
inline constexpr const char* cell_size_dial = "domain.cell_size";

/// Adds to a study what follows from its runs: to a ladder what it says of each measure, to a tradeoff errors, the
/// Pareto set and the cheapest runs.
void derive(v1::Study& study);

}  // namespace trajan
