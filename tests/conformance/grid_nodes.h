#pragma once

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "solver/simulation/simulation.h"

namespace trajan {

/// Of the scenes that boundary conditions are tested in.
inline constexpr double cell = 0.25;

/// What nodes hold after a kick that ended at a sample.
class Nodes {
 public:
  using Index = std::array<std::int64_t, 3>;
  using Components = std::array<double, 3>;
  Nodes(const Simulation& simulation, const Model& model) : axes_(grid_axes(model.dimension)), model_(model) {
    const Tiles& tiles = simulation.executor().tiles();
    const Layout& layout = tiles.layout();
    for (std::size_t t = 0; t < tiles.tiles().size(); ++t)
      for (int node = 0; node < tile_nodes; ++node) {
        const double* values = tiles.nodes(t) + node;
        if (!(values[tile_array(quantity_mass)] > 0)) continue;
        Index at{};
        Components velocity{};
        for (int axis = 0; axis < axes_; ++axis) {
          at[axis] = std::int64_t{tiles.tiles()[t].at[axis]} * layout.side +
                     node / layout.tile_stride(axis) % layout.side;
          velocity[axis] = values[tile_array(quantity(node_velocity, axis, axes_))];
        }
        velocities_[at] = velocity;
      }
  }
  Components origin() const { return {model_.grid.origin.x, model_.grid.origin.y, model_.grid.origin.z}; }
  Components place(const Index& at) const {
    Components place{};
    for (int axis = 0; axis < axes_; ++axis) place[axis] = origin()[axis] + cell * static_cast<double>(at[axis]);
    return place;
  }
  /// By the functions of points: quadratic B-splines in their scenes, else linear ones.
  double interpolated(const Components& at, int component) const {
    Weights along[3] = {{{0, 1}}, {{0, 1}}, {{0, 1}}};
    for (int axis = 0; axis < axes_; ++axis) along[axis] = weights((at[axis] - origin()[axis]) / cell);
    double sum = 0;
    for (const auto& [i, weight_x] : along[0])
      for (const auto& [j, weight_y] : along[1])
        for (const auto& [k, weight_z] : along[2]) {
          const auto found = velocities_.find(Index{i, j, k});
          if (found != velocities_.end()) sum += weight_x * weight_y * weight_z * found->second[component];
        }
    return sum;
  }
  const std::map<Index, Components>& velocities() const { return velocities_; }

 private:
  /// Nodes along an axis with their weights.
  using Weights = std::vector<std::pair<std::int64_t, double>>;
  /// At a coordinate in cells from the domain's lower face. Below it linear functions go on, and of splines those
  /// are folded that lie beyond it (Steffen, Kirby and Berzins 2008).
  Weights weights(double coordinate) const {
    if (model_.numerics.shape_functions != "quadratic_bspline") {
      const double first = std::max(0.0, std::floor(coordinate)), within = coordinate - first;
      return {{static_cast<std::int64_t>(first), 1 - within}, {static_cast<std::int64_t>(first) + 1, within}};
    }
    const double middle = std::max(0.0, std::round(coordinate)), off = coordinate - middle;
    const auto node = static_cast<std::int64_t>(middle);
    const double before = 0.5 * (0.5 - off) * (0.5 - off), behind = 0.5 * (0.5 + off) * (0.5 + off);
    const double here = 0.75 - off * off;
    if (node == 0) return {{0, here + 2 * before}, {1, behind - before}};
    return {{node - 1, before}, {node, here}, {node + 1, behind}};
  }

  int axes_;
  const Model& model_;
  std::map<Index, Components> velocities_;
};

}  // namespace trajan
