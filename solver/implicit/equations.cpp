#include "solver/implicit/equations.h"

#include <algorithm>
#include <cmath>

#include "solver/implicit/stencil_kernels.h"
#include "solver/schemes/kernels.h"

namespace trajan {
namespace {

bool reaches_beyond_a_cell(const Model& model) {
  return kernels().doubles.transfer(model.numerics.shape_functions, model.dimension, Margin::none)->layout.reach !=
         Reach::cell;
}

}  // namespace

double factor_work(double unknowns, double nodes, int axes) {
  const double layer = unknowns / nodes;
  return unknowns * (axes == 3 ? std::pow(layer, 1.5) : layer);
}

double factor_work(const Model& model) {
  const double more = reaches_beyond_a_cell(model) ? 2 : 1;
  const int axes = grid_axes(model.dimension);
  double work = 0;
  for (const Body& body : model.bodies) {
    const double lengths[] = {static_cast<double>(body.lattice.columns) * body.lattice.spacing.x,
                              static_cast<double>(body.lattice.rows) * body.lattice.spacing.y,
                              static_cast<double>(body.lattice.planes) * body.lattice.spacing.z};
    const double box = static_cast<double>(body.lattice.columns * body.lattice.rows * body.lattice.planes);
    double nodes = static_cast<double>(body.particles) / box, longest = 0;
    for (int axis = 0; axis < axes; ++axis) {
      const double along = lengths[axis] / model.grid.cell + more;
      nodes *= along;
      longest = std::max(longest, along);
    }
    work += factor_work(axes * nodes, longest, axes);
  }
  return work;
}

double nodes_in_reach(const Model& model) {
  return polynomial_degree(model.numerics.shape_functions) == 3 ? 4 : reaches_beyond_a_cell(model) ? 3 : 2;
}

double row_entries(const Model& model) {
  const int axes = grid_axes(model.dimension);
  return axes * std::pow(2 * nodes_in_reach(model) - 1, axes);
}

bool takes_multigrid(const Model& model) {
  const Newton* newton = nullptr;
  if (const auto* statics = std::get_if<QuasiStatic>(&model.analysis)) newton = &statics->newton;
  if (const auto* dynamics = std::get_if<ImplicitDynamics>(&model.analysis)) newton = &dynamics->newton;
  if (!newton || newton->linear_solver == LinearSolver::direct) return false;
  return newton->linear_solver == LinearSolver::iterative ||
         (row_entries(model) <= most_row_entries && factor_work(model) > most_factor_work);
}

}  // namespace trajan
