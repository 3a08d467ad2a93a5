#include "solver/simulation/grid_choice.h"

#include "solver/model/spline_degree.h"
#include "solver/transfers/transfer.h"

namespace trajan {
namespace {

Period period_of(const Grid& grid) {
  Period period;
  for (std::size_t axis = 0; axis < period.cells.size(); ++axis)
    if (grid.periodic[axis]) period.cells[axis] = static_cast<std::int32_t>(grid.cells()[axis]);
  return period;
}

}  // namespace

bool get_from_particles_alone(const Model& model, const Conditions& conditions, const Loads& loads) {
  return !conditions.on_surfaces() && !loads.on_surfaces() && model.contacts.fields < 2 &&
         !period_of(model.grid).any();
}

Margin first_margin(const Model& model, const Conditions& conditions, const Loads& loads) {
  // What acts at surfaces goes to nodes of the particles that carry it, but as far as the domains reach over which
  // functions are means.
  const bool beyond_cells = (conditions.on_surfaces() || loads.on_surfaces()) &&
                            point_functions(model.numerics.shape_functions).averaged;
  // Stencils that are moved to lie within the domain begin at another node than their cells' ones.
  const bool moved = splines_keep_degree(model);
  const bool any = beyond_cells || moved || model.contacts.fields > 1 || period_of(model.grid).any();
  return any ? Margin::one_cell : Margin::none;
}

const TransferKernels& transfer_kernels(const Model& model, Margin margin) {
  const Numerics& numerics = model.numerics;
  const TransferKernels& fastest =
      *kernels().grid(numerics).transfer(numerics.shape_functions, model.dimension, margin);
  return find_transfer(numerics.transfer)->general && fastest.general ? *fastest.general : fastest;
}

CellOrder cell_order(const Model& model, const TransferKernels& kernels) {
  const bool strips = find_transfer(model.numerics.transfer)->affine ? kernels.affine.strips : kernels.strips;
  return strips ? CellOrder::strips : CellOrder::cell_by_cell;
}

Tiles make_tiles(const Model& model, const TransferKernels& kernels) {
  const int axes = grid_axes(model.dimension);
  const bool loads = !model.surface_loads.empty() || !model.body_loads.empty();
  return {kernels.layout, quantities(find_transfer(model.numerics.transfer)->node_vectors, axes),
          quantities(loads ? sum_vectors : sum_load, axes), period_of(model.grid)};
}

}  // namespace trajan
