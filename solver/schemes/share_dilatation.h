#pragma once

#include <string_view>

#include "solver/executors/block.h"
#include "solver/scene/scene.h"

namespace trajan {

/// The locking remedy "mean_dilatation" of explicit steps of a total Lagrangian scheme: a stage that comes before
/// a law deforms its particles, and changes the gradient of velocity that it will see. Those of a block that see
/// the same nodes then change their volume alike, by the mean weighted by mass; the pressure that answers is the
/// same in all of them as long as they stay together, so that forces do the work of strains (Simo, Taylor and
/// Pister 1985). Finite laws share the volume ratio to the state at rest, laws in rates that of the step, those of
/// small strains the trace. Precondition: volume is held along all axes (in_volume_dimension).
Stage share_dilatation(std::string_view law, Dimension dimension);

}  // namespace trajan
