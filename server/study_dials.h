#pragma once

#include "trajan/v1/studies.pb.h"

namespace trajan {

/// The cell sizes of a ladder as a dial, the coarsest first. A constant "cell" that is the cell size, a given time
/// step and the number of an implicit motion's time steps go with it. Throws ServiceError INVALID_ARGUMENT for
/// numbers that are out of range.
v1::Dial ladder_dial(const v1::Scene& scene, const v1::Ladder& ladder);

/// The dials of a tradeoff that names none: cell sizes of twice, once and half the scene's, and the methods that
/// could answer it: schemes, shape functions, transfers, time steps, and other analyses of the same question. Of a
/// scene with a constant "cell" that is the cell size, four times, twice and once: its exact values are those at
/// places of particles, which probes of a given size find with cells of the scene's own size at least.
google::protobuf::RepeatedPtrField<v1::Dial> default_dials(const v1::Scene& scene);

}  // namespace trajan
