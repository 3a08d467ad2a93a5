#include "solver/model/spline_degree.h"

#include <algorithm>

#include "solver/schemes/scheme.h"

namespace trajan {

bool splines_keep_degree(const Model& model) {
  constexpr std::int64_t fewest_cells = 4;
  if (model.numerics.locking_remedy != "none") return false;
  const auto cells = model.grid.cells();
  if (std::ranges::any_of(cells, [](std::int64_t n) { return n > 0 && n < fewest_cells; })) return false;
  if (const auto* modal = std::get_if<Modal>(&model.analysis)) return modal->mass == MassMatrix::consistent;
  if (const auto* dynamics = std::get_if<ImplicitDynamics>(&model.analysis))
    return dynamics->mass == MassMatrix::consistent && is_total_lagrangian(model.numerics.scheme);
  return std::holds_alternative<QuasiStatic>(model.analysis) || std::holds_alternative<Buckling>(model.analysis);
}

}  // namespace trajan
