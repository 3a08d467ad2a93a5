#pragma once

#include "solver/scene/scene.h"

namespace trajan {

/// Whether the axes that the grid lacks are free of stress, not of strain.
constexpr bool rest_is_free(Dimension dimension) {
  return dimension == Dimension::bar || dimension == Dimension::plane_stress;
}

}  // namespace trajan
