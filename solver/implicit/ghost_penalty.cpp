#include "solver/implicit/ghost_penalty.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/implicit/stencil_kernels.h"
#include "solver/model/spline_degree.h"
#include "solver/surfaces/spline_faces.h"

namespace trajan {
namespace {

/// Of the wave modulus. Errors and condition numbers are flat from 0.01 to 1.
constexpr double penalty = 0.1;

/// Along one axis, the share of what a node inside the body has below which a node is light. On the outermost node
/// of a body whose face lies on nodes of the grid it is 1/2, 1/48 or 1/24 for splines of degree 1, 2, 3, and 1/16
/// at the end of a Bernstein element that the face cuts in half; somewhat less if two particles sum it up.
double light_share(std::string_view shape_functions) {
  if (shape_functions == "quadratic_bspline") return 0.01;
  if (shape_functions == "cubic_bspline") return 0.03;
  return shape_functions == "bernstein" ? 0.05 : 0.3;
}

/// What vanishes where functions go on as one polynomial, as coefficients of consecutive nodes.
struct Jump {
  std::vector<double> coefficients;
  int every = 1, first = 0;  ///< which nodes it may begin with: every so many from this one on
};

std::vector<Jump> jumps_of(std::string_view shape_functions) {
  // First and second derivatives beside a joint of elements of two cells, from their control points; of the latter
  // half a cell's length.
  if (shape_functions == "bernstein") return {{{1, -2, 1}, 2, 1}, {{-0.5, 1, 0, -1, 0.5}, 2, 0}};
  const int order = polynomial_degree(shape_functions) + 1;
  std::vector<double> binomials{1};
  for (int k = 1; k <= order; ++k) binomials.push_back(-binomials.back() * (order - k + 1) / k);
  return {{binomials}};
}

/// Volume and wave modulus times volume that the particles give to each node.
struct NodeVolumes {
  std::vector<double> volume, stiffness;

  NodeVolumes(const Model& model, const Discretization& on) : volume(on.nodes()), stiffness(on.nodes()) {
    std::vector<double> modulus;
    for (const Body& body : model.bodies) {
      const Material& material = model.materials[body.material];
      const double speed = material.kind->wave_speed(material.parameters, material.density, model.dimension);
      modulus.push_back(material.density * speed * speed);
    }
    for (std::size_t p = 0; p < on.particles(); ++p) {
      const Discretization::Particle particle = on.particle(p);
      for (std::size_t k = 0; k < particle.nodes.size(); ++k) {
        const double share = particle.weights[k] * on.volume(p);
        volume[particle.nodes[k]] += share;
        stiffness[particle.nodes[k]] += share * modulus[on.body(p)];
      }
    }
  }
};

}  // namespace

GhostPenalty::GhostPenalty(const Model& model, const Discretization& on) {
  const std::string& shapes = model.numerics.shape_functions;
  const bool bernstein = shapes == "bernstein";
  const int axes = on.axes();
  const double h = model.grid.cell, full = std::pow(h, axes) * model.thickness;
  const PointFunctions& functions = point_functions(shapes);
  const bool to_faces = functions.folds && splines_keep_degree(model);
  const NodeVolumes nodes(model, on);
  const auto radius = [&](std::size_t n) {
    const double r = model.grid.origin.x + h * static_cast<double>(on.grid_index(n)[0]);
    return on.axisymmetric() ? std::max(r, 0.5 * h) : 1.0;
  };
  // Volumes of nodes, as shares of what they are inside a body.
  std::vector<double> filled(on.nodes());
  for (std::size_t n = 0; n < on.nodes(); ++n) {
    double whole = full * radius(n);
    // Joints of Bernstein elements have two thirds of both, the nodes between them of one.
    if (bernstein)
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis)
        whole *= on.grid_index(n)[axis] % 2 == 0 ? 4.0 / 3 : 2.0 / 3;
    filled[n] = nodes.volume[n] / whole;
  }
  const double share = light_share(shapes), light = std::pow(share, axes);

  const auto add = [&](const Jump& jump, std::size_t first, int axis) {
    const std::int64_t index = on.grid_index(first)[static_cast<std::size_t>(axis)];
    if (index % jump.every != jump.first) return;
    Difference difference{{}, jump.coefficients, 0};
    double volume = 0, stiffness = 0, least = std::numeric_limits<double>::infinity(), most = 0;
    const int last = static_cast<int>(jump.coefficients.size()) - 1;
    for (int k = 0; k <= last; ++k) {
      const std::int32_t next = on.neighbour(first, axis, k);
      if (next < 0) return;
      const auto n = static_cast<std::uint32_t>(next);
      difference.nodes.push_back(n);
      least = std::min(least, filled[n]);
      most = std::max(most, filled[n]);
      volume += nodes.volume[n];
      stiffness += nodes.stiffness[n];
    }
    if (!(least < light && volume > 0)) return;
    // Where nodes are light because of another axis, first derivatives must jump to let elements bend.
    if (bernstein && least >= share * most) return;
    if (to_faces && !model.grid.periodic[static_cast<std::size_t>(axis)]) {
      double* coefficients = difference.coefficients.data();
      const std::int64_t cells = model.grid.cells()[static_cast<std::size_t>(axis)];
      if (index == 0) put_value_on_face(functions, 0, coefficients);
      if (index + last == cells) put_value_on_face(functions, functions.nodes - 1, coefficients + 1);
    }
    // A cell's stiffness: modulus times volume over the square of the cell size.
    difference.stiffness = penalty * stiffness / volume * full * radius(first) / (h * h);
    differences_.push_back(std::move(difference));
  };
  const std::vector<Jump> jumps = jumps_of(shapes);
  for (std::size_t first = 0; first < on.nodes(); ++first)
    for (int axis = 0; axis < axes; ++axis)
      for (const Jump& jump : jumps) add(jump, first, axis);
}

}  // namespace trajan
