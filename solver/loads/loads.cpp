#include "solver/loads/loads.h"

#include <algorithm>
#include <utility>

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
  lasting_.assign(riders_.size(), {});
  for (std::size_t i = 0; i < riders_.size(); ++i)
    if (lasts(i)) find_lasting(i, bodies, tiles);
}

bool Loads::lasts(std::size_t load) const {
  const Riders& riders = riders_[load];
  return riders.total_lagrangian() && !riders.follow() && !riders.functions().averaged;
}

void Loads::find_lasting(std::size_t load, const std::vector<BodyParticles>& bodies, const Tiles& tiles) {
  std::vector<NodeForce>& all = lasting_[load];
  for (std::size_t p = 0; p < riders_[load].size(); ++p)
    give(load, p, place(load, p, tiles, bodies, Riders::Of::force),
         [&](const NodeForce& one) { all.push_back(one); });
  const auto node_of = [](const NodeForce& one) { return std::pair(one.tile, one.node); };
  std::ranges::stable_sort(all, {}, node_of);
  std::size_t nodes = 0;
  for (const NodeForce& one : all) {
    if (nodes > 0 && node_of(all[nodes - 1]) == node_of(one)) {
      Vector& sum = all[nodes - 1].force;
      sum = {sum.x + one.force.x, sum.y + one.force.y, sum.z + one.force.z};
    } else {
      all[nodes++] = one;
    }
  }
  all.resize(nodes);
  all.shrink_to_fit();
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

/// Calls of(NodeForce) for each node that a point's force goes to, for a factor of one.
template <class Of>
void Loads::give(std::size_t load, std::size_t p, const PlaceOfForce& at, Of&& of) const {
  const Riders& riders = riders_[load];
  const LoadPoint& point = model_.surface_loads[load].points[p];
  Vector force = point.force;
  if (riders.follow()) {
    const Vector area = riders.area(p);
    force = {-point.pressure * area.x, -point.pressure * area.y, -point.pressure * area.z};
  }
  for (int n = 0; n < riders.corners(); ++n) {
    const double weight = at.weights[n];
    of(NodeForce{at.stencil.tile,
                 at.stencil.node + riders.corner(n),
                 {weight * force.x, weight * force.y, weight * force.z}});
  }
}

Loads::PlaceOfForce Loads::place(std::size_t load, std::size_t p, const Tiles& tiles,
                                 const std::vector<BodyParticles>& bodies, Riders::Of of) const {
  const Riders::Stencil stencil = riders_[load].stencil(tiles, bodies, p, of);
  return {stencil, riders_[load].weights(stencil, stencil.of_point)};
}

Loads::PlaceOfForce Loads::place_on_mass(std::size_t load, std::size_t p, Tiles& tiles,
                                         const std::vector<BodyParticles>& bodies) const {
  const Riders& riders = riders_[load];
  const PlaceOfForce at = place(load, p, tiles, bodies, Riders::Of::force);
  if (!riders.functions().averaged) return at;
  const double* mass = tiles.sums(at.stencil.tile) + tiles.layout().window_array(quantity_mass) + at.stencil.node;
  return reaches_mass(mass, riders, at.weights) ? at : place(load, p, tiles, bodies, Riders::Of::velocity);
}

void Loads::add_to(Tiles& tiles, const std::vector<BodyParticles>& bodies) {
  const Layout& layout = tiles.layout();
  loaded_.clear(tiles);
  for (std::size_t i = 0; i < riders_.size(); ++i) {
    const auto add = [&](const NodeForce& one) {
      double* sums = loaded_.sums(tiles, one.tile) + one.node;
      for (int axis = 0; axis < axes_; ++axis)
        sums[layout.window_array(axis)] += factors_[i] * component(one.force, axis);
    };
    for (const NodeForce& one : lasting_[i]) add(one);
    for (std::size_t p = 0; !lasts(i) && p < riders_[i].size(); ++p)
      give(i, p, place_on_mass(i, p, tiles, bodies), add);
  }
}

void Loads::advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) {
  for (Riders& riders : riders_) riders.advect(tiles, bodies, drift);
}

void Loads::displace(const Tiles& tiles, const std::vector<BodyParticles>& bodies) {
  for (Riders& riders : riders_) riders.displace(tiles, bodies);
}

}  // namespace trajan
