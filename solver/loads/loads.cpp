#include "solver/loads/loads.h"

#include <algorithm>

#include "solver/simulation/particles.h"

namespace trajan {
namespace {

/// Of the heaviest of a stencil's nodes: one with a smaller share would keep what it is given to itself.
constexpr double least_share = 1e-12;

/// Whether particles see all nodes that a force goes to. Turned domains have no corner in some cells that they
/// reach.
bool reaches_mass(const double* mass, const Riders& riders, const Riders::Values& weights) {
  double most = 0;
  for (int n = 0; n < riders.corners(); ++n) most = std::max(most, mass[riders.corner(n)]);
  for (int n = 0; n < riders.corners(); ++n)
    if (weights[n] != 0 && !(mass[riders.corner(n)] > least_share * most)) return false;
  return true;
}

}  // namespace

Loads::Loads(const Model& model)
    : model_(model),
      axes_(grid_axes(model.dimension)),
      fields_(model),
      loaded_(model),
      factors_(model.surface_loads.size()) {
  for (const SurfaceLoad& load : model.surface_loads) {
    std::vector<SurfacePoint> points(load.points.begin(), load.points.end());
    riders_.emplace_back(model, std::move(points), load.follows, point_functions(model.numerics.shape_functions));
  }
}

void Loads::bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles) {
  for (Riders& riders : riders_) riders.bind(bodies, tiles);
  loaded_.bind(tiles);
}

void Loads::prepare(std::vector<BodyParticles>& bodies, double time) {
  for (std::size_t i = 0; i < factors_.size(); ++i) factors_[i] = model_.surface_loads[i].time(time);
  if (model_.body_loads.empty()) return;
  fields_.evaluate(bodies, time);
  for (BodyParticles& body : bodies)
    for (double& a : body.constants.acceleration) a = 0;
  for (const BodyLoad& load : model_.body_loads) {
    const double factor = load.time(time);
    for (std::size_t b : load.bodies)
      for (int axis = 0; axis < axes_; ++axis)
        bodies[b].constants.acceleration[axis] += factor / bodies[b].inertia * component(load.acceleration, axis);
  }
}

void Loads::add_to(Tiles& tiles, const std::vector<BodyParticles>& bodies) {
  const Layout& layout = tiles.layout();
  loaded_.clear(tiles);
  for (std::size_t i = 0; i < riders_.size(); ++i) {
    const SurfaceLoad& load = model_.surface_loads[i];
    for (std::size_t p = 0; p < load.points.size(); ++p) {
      const LoadPoint& point = load.points[p];
      Vector force = point.force;
      if (load.follows) {
        const Vector area = riders_[i].area(p);
        force = {-point.pressure * area.x, -point.pressure * area.y, -point.pressure * area.z};
      }
      Riders::Stencil s = riders_[i].stencil(tiles, bodies, p, Riders::Of::force);
      Riders::Values weights = riders_[i].weights(s, s.of_point);
      const double* mass = tiles.sums(s.tile) + layout.window_array(quantity_mass) + s.node;
      if (riders_[i].functions().averaged && !reaches_mass(mass, riders_[i], weights)) {
        s = riders_[i].stencil(tiles, bodies, p);
        weights = riders_[i].weights(s, s.of_point);
      }
      double* of_tile = loaded_.sums(tiles, s.tile);
      for (int axis = 0; axis < axes_; ++axis) {
        double* sums = of_tile + layout.window_array(axis) + s.node;
        for (int n = 0; n < riders_[i].corners(); ++n)
          sums[riders_[i].corner(n)] += weights[n] * factors_[i] * component(force, axis);
      }
    }
  }
}

void Loads::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  for (Riders& riders : riders_) riders.advect(tiles, bodies, drift);
}

void Loads::displace(const Tiles& tiles, const std::vector<BodyParticles>& bodies) {
  for (Riders& riders : riders_) riders.displace(tiles, bodies);
}

}  // namespace trajan
