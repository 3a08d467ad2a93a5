#include "solver/implicit/ghost_penalty.h"

#include <cmath>

#include "solver/implicit/stencil_kernels.h"

namespace trajan {
namespace {

/// Of the wave modulus. Errors and condition numbers are flat from 0.01 to 1.
constexpr double penalty = 0.1;

/// Along one axis, the share of a cell's volume below which a node is light. On the outermost node of a body whose
/// face lies on nodes of the grid it is 1/2, 1/48 or 1/24 for splines of degree 1, 2, 3, and somewhat less if two
/// particles sum it up.
double light_share(int degree) { return degree == 1 ? 0.3 : degree == 2 ? 0.01 : 0.03; }

std::vector<double> binomials(int order) {
  std::vector<double> c{1};
  for (int k = 1; k <= order; ++k) c.push_back(-c.back() * (order - k + 1) / k);
  return c;
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
  const int degree = polynomial_degree(model.numerics.shape_functions), axes = on.axes();
  const double h = model.grid.cell, full = std::pow(h, axes) * model.thickness;
  coefficients_ = binomials(degree + 1);
  const NodeVolumes nodes(model, on);
  const auto radius = [&](std::size_t n) {
    const double r = model.grid.origin.x + h * static_cast<double>(on.grid_index(n)[0]);
    return on.axisymmetric() ? std::max(r, 0.5 * h) : 1.0;
  };
  std::vector<char> light(on.nodes());
  const double least = std::pow(light_share(degree), axes) * full;
  for (std::size_t n = 0; n < on.nodes(); ++n) light[n] = nodes.volume[n] < least * radius(n);

  for (std::size_t first = 0; first < on.nodes(); ++first)
    for (int axis = 0; axis < axes; ++axis) {
      Difference difference{{static_cast<std::uint32_t>(first)}, 0};
      for (int k = 1; k <= degree + 1; ++k) {
        const std::int32_t next = on.neighbour(first, axis, k);
        if (next < 0) break;
        difference.nodes.push_back(static_cast<std::uint32_t>(next));
      }
      if (difference.nodes.size() < coefficients_.size()) continue;
      bool any = false;
      double volume = 0, stiffness = 0;
      for (std::uint32_t n : difference.nodes) {
        any = any || light[n];
        volume += nodes.volume[n];
        stiffness += nodes.stiffness[n];
      }
      if (!any || !(volume > 0)) continue;
      // A cell's stiffness: modulus times volume over the square of the cell size.
      difference.stiffness = penalty * stiffness / volume * full * radius(first) / (h * h);
      differences_.push_back(std::move(difference));
    }
}

}  // namespace trajan
