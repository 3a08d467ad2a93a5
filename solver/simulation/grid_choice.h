#pragma once

#include "solver/boundaries/conditions.h"
#include "solver/executors/tiles.h"
#include "solver/loads/loads.h"
#include "solver/schemes/kernels.h"
#include "solver/simulation/particles.h"

/// What a model's grid is made of.
namespace trajan {

/// Whether nodes get something from their own body's particles alone: nothing at surfaces, no contact, no images.
bool get_from_particles_alone(const Model& model, const Conditions& conditions, const Loads& loads);

/// What windows have as long as all particles are in their tiles.
Margin first_margin(const Model& model, const Conditions& conditions, const Loads& loads);

/// The kernels of a model's shape functions and transfer.
const TransferKernels& transfer_kernels(const Model& model, Margin margin);

/// In which particles lie within a tile, for these kernels.
CellOrder cell_order(const Model& model, const TransferKernels& kernels);

/// Of nodes with all that these kernels need.
Tiles make_tiles(const Model& model, const TransferKernels& kernels);

}  // namespace trajan
