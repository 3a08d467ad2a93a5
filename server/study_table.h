#pragma once

#include "trajan/v1/studies.pb.h"

namespace trajan {

/// The dial whose settings are cell sizes, named by their numbers.
inline constexpr const char* cell_size_dial = "domain.cell_size";

/// Null if the run has none of this name.
const v1::MeasureValue* find_measure(const v1::Run& run, const std::string& name);

/// See solver/accuracy/extrapolation.h.
bool is_check(const v1::Scene& scene, const v1::MeasureValue& value);

/// Adds to a study of this scene what follows from its runs: to a ladder what it says of each measure, to a
/// tradeoff errors, the Pareto set and the cheapest runs.
void derive(v1::Study& study, const v1::Scene& scene);

}  // namespace trajan
