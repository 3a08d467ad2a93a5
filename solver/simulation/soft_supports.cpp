#include "solver/simulation/soft_supports.h"

#include <algorithm>

#include "solver/model/names.h"

namespace trajan {
namespace {

/// Whether nodes lie in one face of the domain, or are all there are.
bool are_of_a_face(const NodeRegion& nodes, const Grid& grid, int axes) {
  const std::int64_t lowest[] = {nodes.i0, nodes.j0, nodes.k0}, highest[] = {nodes.i1, nodes.j1, nodes.k1};
  bool all = true;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
    const std::int64_t last = grid.cells()[axis];
    const bool flat = lowest[axis] == highest[axis] && !grid.periodic[axis];
    if (flat && (lowest[axis] == 0 || lowest[axis] == last)) return true;
    all = all && lowest[axis] <= 0 && highest[axis] >= last;
  }
  return all;
}

}  // namespace

std::vector<Warning> warnings_of_soft_supports(const Model& model) {
  if (!model.numerics.shape_functions.ends_with("bspline")) return {};
  std::vector<Warning> all;
  for (const BoundaryCondition& condition : model.conditions) {
    const auto* motion = std::get_if<PrescribedMotion>(&condition.kind);
    if (motion == nullptr || are_of_a_face(motion->nodes, model.grid, grid_axes(model.dimension))) continue;
    Warning warning;
    warning.name = "soft support by " + quoted(condition.name);
    warning.particle = model.bodies[0].first_particle;
    warning.place = model.bodies[0].lattice.point_of(0);
    warning.cause =
        "boundary " + quoted(condition.name) +
        " holds nodes within the domain, whose values B-splines do not take: a body that ends there is "
        "held as softly as if it were one to three cells longer";
    warning.remedy = "let the domain begin or end where the body is held, or hold its surface by a hinge";
    all.push_back(warning);
  }
  return all;
}

}  // namespace trajan
