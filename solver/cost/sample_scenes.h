#pragma once

#include "solver/materials/material.h"
#include "solver/scene/scene.h"

namespace trajan {

/// A block of so many cells along each axis that the dimension has, with so many particles along a cell's side,
/// which vibrates a little: what rates are measured with. `kind`: of its material.
Scene sample_block(Dimension dimension, const MaterialKind& kind, int cells, int particles);

/// The same in two halves that touch.
Scene sample_contact(Dimension dimension, const MaterialKind& kind, int cells, int particles);

}  // namespace trajan
