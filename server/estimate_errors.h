#pragma once

#include "server/estimate.h"

namespace trajan {

/// Adds to an estimate what the family's findings say of the measures' errors.
void estimate_errors(const v1::Scene& scene, const Evidence& evidence, v1::Estimate& estimate);

/// Adds to an estimate that is complete otherwise what other settings would do.
void name_neighbours(const v1::Scene& scene, const Evidence& evidence, v1::Estimate& estimate);

}  // namespace trajan
