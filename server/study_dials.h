#pragma once

#include <vector>

#include "trajan/v1/studies.pb.h"

namespace trajan {

/// Another cell size, with all that the scene has in proportion to it: a constant "cell" that is the cell size, a
/// given time step and the number of an implicit motion's time steps.
v1::Setting with_cell_size(const v1::Scene& scene, double cell_size);

/// The largest length of which the edges of all boxes that are bodies, and their distances from the domain's
/// corner, are whole multiples: its parts are cells that they cut alike. Those of probes too, as long as there is
/// such a length that is no smaller than the scene's cells. 0 if there are no boxes.
double common_length(const v1::Scene& scene);

/// The cell sizes of a ladder as a dial, the coarsest first. Throws ServiceError INVALID_ARGUMENT for
/// numbers that are out of range.
v1::Dial ladder_dial(const v1::Scene& scene, const v1::Ladder& ladder);

/// The dials of a tradeoff that names none: cell sizes of twice, once and half the scene's, and the methods that
/// could answer it: schemes, shape functions, transfers, time steps, and other analyses of the same question. Of a
/// scene with a constant "cell" that is the cell size, four times, twice and once: its exact values are those at
/// places of particles, which probes of a given size find with cells of the scene's own size at least.
google::protobuf::RepeatedPtrField<v1::Dial> default_dials(const v1::Scene& scene);

/// Ways to the answer for a target to climb by, the most promising first, those that are not valid too: of elastic
/// bodies total Lagrangian with linear and with quadratic functions, then what the scene says.
std::vector<v1::Setting> target_methods(const v1::Scene& scene);

}  // namespace trajan
