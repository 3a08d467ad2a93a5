#include "solver/boundaries/node_conditions.h"

#include <algorithm>
#include <cmath>

namespace trajan {
namespace {

/// Regions catch nodes to this many cell sizes, as boundaries.proto says.
constexpr double tolerance = 1e-9;

bool contains(const NodeRegion& region, const Grid& grid, std::int64_t i, std::int64_t j) {
  if (i < region.i0 || i > region.i1 || j < region.j0 || j > region.j1) return false;
  if (!region.disc) return true;
  const double x = grid.origin.x + grid.cell * static_cast<double>(i) - region.disc->centre.x;
  const double y = grid.origin.y + grid.cell * static_cast<double>(j) - region.disc->centre.y;
  return std::hypot(x, y) <= region.disc->radius + tolerance * grid.cell;
}

bool may_touch(const NodeRegion& region, const Tile& tile) {
  const std::int64_t i = std::int64_t{tile.x} * tile_side, j = std::int64_t{tile.y} * tile_side;
  return i <= region.i1 && i + tile_side > region.i0 && j <= region.j1 && j + tile_side > region.j0;
}

bool is_zero(const std::optional<Expression>& velocity) {
  return !velocity || velocity->text().find_first_not_of(" 0.") == std::string::npos;
}

}  // namespace

NodeConditions::NodeConditions(const Model& model)
    : model_(model), conditions_(model.conditions), velocities_(2 * model.conditions.size()) {
  for (const NodeCondition& c : conditions_) work_ = work_ || !is_zero(c.velocity_x) || !is_zero(c.velocity_y);
}

void NodeConditions::bind(const Tiles& tiles) {
  entries_.clear();
  first_.assign(1, 0);
  for (const Tile& tile : tiles.tiles()) {
    for (int node = 0; node < tile_nodes; ++node) {
      const std::int64_t i = std::int64_t{tile.x} * tile_side + node % tile_side;
      const std::int64_t j = std::int64_t{tile.y} * tile_side + node / tile_side;
      int last[2] = {-1, -1};  // later conditions win
      for (std::size_t c = 0; c < conditions_.size(); ++c) {
        if (!may_touch(conditions_[c].nodes, tile) || !contains(conditions_[c].nodes, model_.grid, i, j)) continue;
        if (conditions_[c].velocity_x) last[0] = static_cast<int>(c);
        if (conditions_[c].velocity_y) last[1] = static_cast<int>(c);
      }
      for (int axis = 0; axis < 2; ++axis)
        if (last[axis] >= 0)
          entries_.push_back({static_cast<std::uint16_t>(last[axis]), static_cast<std::uint8_t>(axis),
                              static_cast<std::uint8_t>(node)});
    }
    first_.push_back(static_cast<std::uint32_t>(entries_.size()));
  }
}

void NodeConditions::evaluate(double before, double after, double kick) {
  const auto set = [&](const std::optional<Expression>& expression, Velocity& velocity) {
    if (!expression) return;
    velocity.after = (*expression)(0, 0, after);
    velocity.acceleration = (velocity.after - (*expression)(0, 0, before)) / kick;
  };
  for (std::size_t c = 0; c < conditions_.size(); ++c) {
    set(conditions_[c].velocity_x, velocities_[2 * c]);
    set(conditions_[c].velocity_y, velocities_[2 * c + 1]);
  }
}

double NodeConditions::prescribe(std::size_t tile, double* nodes, double kick) const {
  double work = 0;
  for (const Entry& entry : entries_of(tile)) {
    const Velocity& v = velocities_[2 * entry.condition + entry.axis];
    double& a = nodes[(node_acceleration_x + entry.axis) * tile_nodes + entry.node];
    double& u = nodes[(node_velocity_x + entry.axis) * tile_nodes + entry.node];
    const double reaction = nodes[node_mass * tile_nodes + entry.node] * (v.acceleration - a);
    work += kick * reaction * (v.after - 0.5 * kick * v.acceleration);
    a = v.acceleration;
    u = v.after;
  }
  return work;
}

void NodeConditions::prescribe_mapped(std::size_t tile, double* nodes) const {
  for (const Entry& entry : entries_of(tile))
    nodes[(node_mapped_velocity_x + entry.axis) * tile_nodes + entry.node] =
        velocities_[2 * entry.condition + entry.axis].after;
}

}  // namespace trajan
