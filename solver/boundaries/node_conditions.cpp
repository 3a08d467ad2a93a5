#include "solver/boundaries/node_conditions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trajan {
namespace {

/// Regions catch nodes to this many cell sizes, as boundaries.proto says.
constexpr double tolerance = 1e-9;

using NodeIndex = std::array<std::int64_t, 3>;

bool contains(const NodeRegion& region, const Grid& grid, const NodeIndex& node) {
  const NodeIndex lowest{region.i0, region.j0, region.k0}, highest{region.i1, region.j1, region.k1};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (node[axis] < lowest[axis] || node[axis] > highest[axis]) return false;
  if (!region.disc) return true;
  const double x = grid.origin.x + grid.cell * static_cast<double>(node[0]) - region.disc->centre.x;
  const double y = grid.origin.y + grid.cell * static_cast<double>(node[1]) - region.disc->centre.y;
  return std::hypot(x, y) <= region.disc->radius + tolerance * grid.cell;
}

bool may_touch(const NodeRegion& region, const Layout& layout, const Tile& tile) {
  const NodeIndex lowest{region.i0, region.j0, region.k0}, highest{region.i1, region.j1, region.k1};
  for (int axis = 0; axis < layout.dimensions; ++axis) {
    const std::int64_t first = std::int64_t{tile.at[axis]} * layout.side;
    if (first > highest[axis] || first + layout.side <= lowest[axis]) return false;
  }
  return true;
}

const std::optional<Expression>& velocity(const NodeCondition& condition, int axis) {
  return axis == 0 ? condition.velocity_x : axis == 1 ? condition.velocity_y : condition.velocity_z;
}

bool is_zero(const std::optional<Expression>& velocity) {
  return !velocity || velocity->text().find_first_not_of(" 0.") == std::string::npos;
}

}  // namespace

NodeConditions::NodeConditions(const Model& model)
    : model_(model),
      axes_(grid_axes(model.dimension)),
      conditions_(model.conditions),
      velocities_(3 * model.conditions.size()) {
  for (const NodeCondition& c : conditions_)
    work_ = work_ || !is_zero(c.velocity_x) || !is_zero(c.velocity_y) || !is_zero(c.velocity_z);
}

void NodeConditions::bind(const Tiles& tiles) {
  const Layout& layout = tiles.layout();
  entries_.clear();
  first_.assign(1, 0);
  for (const Tile& tile : tiles.tiles()) {
    for (int node = 0; node < tile_nodes; ++node) {
      NodeIndex at{};
      for (int axis = 0; axis < layout.dimensions; ++axis)
        at[axis] = std::int64_t{tile.at[axis]} * layout.side + node / layout.tile_stride(axis) % layout.side;
      int last[3] = {-1, -1, -1};  // later conditions win
      for (std::size_t c = 0; c < conditions_.size(); ++c) {
        if (!may_touch(conditions_[c].nodes, layout, tile) || !contains(conditions_[c].nodes, model_.grid, at))
          continue;
        for (int axis = 0; axis < layout.dimensions; ++axis)
          if (velocity(conditions_[c], axis)) last[axis] = static_cast<int>(c);
      }
      for (int axis = 0; axis < layout.dimensions; ++axis)
        if (last[axis] >= 0)
          entries_.push_back({static_cast<std::uint16_t>(last[axis]), static_cast<std::uint8_t>(axis),
                              static_cast<std::uint8_t>(node)});
    }
    first_.push_back(static_cast<std::uint32_t>(entries_.size()));
  }
}

void NodeConditions::evaluate(double before, double after, double kick) {
  for (std::size_t c = 0; c < conditions_.size(); ++c)
    for (int axis = 0; axis < 3; ++axis) {
      const std::optional<Expression>& expression = velocity(conditions_[c], axis);
      if (!expression) continue;
      Velocity& v = velocities_[3 * c + static_cast<std::size_t>(axis)];
      v.after = (*expression)(0, 0, after);
      v.acceleration = (v.after - (*expression)(0, 0, before)) / kick;
    }
}

double NodeConditions::prescribe(std::size_t tile, double* nodes, double kick) const {
  double work = 0;
  for (const Entry& entry : entries_of(tile)) {
    const Velocity& v = velocities_[3 * entry.condition + entry.axis];
    double& a = nodes[quantity(node_acceleration, entry.axis, axes_) * tile_nodes + entry.node];
    double& u = nodes[quantity(node_velocity, entry.axis, axes_) * tile_nodes + entry.node];
    const double reaction = nodes[quantity_mass * tile_nodes + entry.node] * (v.acceleration - a);
    work += kick * reaction * (v.after - 0.5 * kick * v.acceleration);
    a = v.acceleration;
    u = v.after;
  }
  return work;
}

void NodeConditions::prescribe_mapped(std::size_t tile, double* nodes) const {
  for (const Entry& entry : entries_of(tile))
    nodes[quantity(node_mapped_velocity, entry.axis, axes_) * tile_nodes + entry.node] =
        velocities_[3 * entry.condition + entry.axis].after;
}

}  // namespace trajan
