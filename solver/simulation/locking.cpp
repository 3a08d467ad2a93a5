#include "solver/simulation/locking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/implicit/stencil_kernels.h"
#include "solver/model/names.h"
#include "solver/schemes/scheme.h"

namespace trajan {
namespace {

/// Stiffness against changes of volume, in units of that against shear, beyond which displacements are more than
/// one per cent too small: Poisson's ratio 0.474 with linear functions, 0.495 with smoother ones, of which Cook's
/// membrane takes some per cent (README.md) and a thick cylinder nothing (tests/stability: poissons_ratios).
constexpr double nearly_incompressible = 20, nearly_incompressible_smooth = 100;

/// The least ratio, over the grid's axes, of the moduli of waves along and across them; a fluid has none.
double volume_over_shear(const Material& material, Dimension dimension) {
  const auto axes = static_cast<std::size_t>(grid_axes(dimension));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < axes; ++axis) {
    std::array<double, 9> tensor{};
    material.kind->acoustic_tensor(material.parameters, material.density, dimension, static_cast<int>(axis),
                                   tensor);
    for (std::size_t other = 0; other < axes; ++other)
      if (other != axis && tensor[other * (axes + 1)] > 0)
        least = std::min(least, tensor[axis * (axes + 1)] / tensor[other * (axes + 1)]);
  }
  return least < std::numeric_limits<double>::infinity() ? least : 0;
}

}  // namespace

std::vector<Warning> warnings_of_locking(const Model& model) {
  const bool thin = model.dimension == Dimension::bar || model.dimension == Dimension::plane_stress;
  if (thin || model.numerics.locking_remedy != "none") return {};
  std::vector<Warning> all;
  const bool smooth = polynomial_degree(model.numerics.shape_functions) > 1;
  for (const Body& body : model.bodies) {
    const Material& material = model.materials[body.material];
    const double ratio = volume_over_shear(material, model.dimension);
    if (ratio <= (smooth ? nearly_incompressible_smooth : nearly_incompressible)) continue;
    Warning warning;
    warning.name = "locking of " + quoted(body.name);
    warning.particle = body.first_particle;
    bool first = true;
    body.lattice.for_each_point([&](std::int64_t, Vector at) {
      if (first) warning.place = at;
      first = false;
    });
    warning.cause = "body " + quoted(body.name) + " resists changes of its volume " +
                    number_text(std::round(ratio)) + " times as much as shear: it locks, and moves too little";
    const bool is_explicit = std::holds_alternative<ExplicitDynamics>(model.analysis) ||
                             std::holds_alternative<Relaxation>(model.analysis);
    warning.remedy = "give numerics.locking_remedy: \"mean_dilatation\"";
    if (is_explicit && !is_total_lagrangian(model.numerics.scheme))
      warning.remedy += " with numerics.scheme: \"TLMPM\" or an implicit analysis";
    all.push_back(warning);
  }
  return all;
}

}  // namespace trajan
