#include <algorithm>
#include <cmath>

#include "solver/model/selection.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

/// The nodes within a region to a tolerance in cells, clipped to the grid.
NodeRegion nodes_in(const Grid& grid, const Region& region, double tolerance) {
  NodeRegion nodes;
  Box box;
  if (const Disc* disc = std::get_if<Disc>(&region)) {
    nodes.disc = Disc{disc->centre, disc->radius + tolerance * grid.cell};
    box = {{disc->centre.x - disc->radius, disc->centre.y - disc->radius},
           {disc->centre.x + disc->radius, disc->centre.y + disc->radius}};
  } else {
    box = std::get<Box>(region);
  }
  const auto first = [&](double coordinate, double origin, std::int64_t cells) {
    const double index = std::ceil((coordinate - origin) / grid.cell - tolerance);
    return static_cast<std::int64_t>(std::clamp(index, 0.0, static_cast<double>(cells + 1)));
  };
  const auto last = [&](double coordinate, double origin, std::int64_t cells) {
    const double index = std::floor((coordinate - origin) / grid.cell + tolerance);
    return static_cast<std::int64_t>(std::clamp(index, -1.0, static_cast<double>(cells)));
  };
  nodes.i0 = first(box.lower.x, grid.origin.x, grid.cells_x);
  nodes.i1 = last(box.upper.x, grid.origin.x, grid.cells_x);
  nodes.j0 = first(box.lower.y, grid.origin.y, grid.cells_y);
  nodes.j1 = last(box.upper.y, grid.origin.y, grid.cells_y);
  nodes.k0 = first(box.lower.z, grid.origin.z, grid.cells_z);
  nodes.k1 = last(box.upper.z, grid.origin.z, grid.cells_z);
  return nodes;
}

/// A disc catches a node if it catches the one that is nearest to its centre.
bool is_empty(const Grid& grid, const NodeRegion& nodes) {
  if (nodes.i0 > nodes.i1 || nodes.j0 > nodes.j1 || nodes.k0 > nodes.k1) return true;
  if (!nodes.disc) return false;
  const auto nearest = [&](double coordinate, double origin, std::int64_t cells) {
    const double index =
        std::clamp(std::round((coordinate - origin) / grid.cell), 0.0, static_cast<double>(cells));
    return origin + index * grid.cell;
  };
  const Vector node = {nearest(nodes.disc->centre.x, grid.origin.x, grid.cells_x),
                       nearest(nodes.disc->centre.y, grid.origin.y, grid.cells_y)};
  return distance_from(*nodes.disc, node) > 0;
}

}  // namespace

void Validator::check_boundaries() {
  if (!check_list("boundaries", scene_.boundaries)) return;
  for (std::size_t i = 0; i < scene_.boundaries.size(); ++i) {
    check_boundary(indexed("boundaries", i), scene_.boundaries[i]);
  }
}

void Validator::check_boundary(const std::string& path, const BoundaryDefinition& definition) {
  NodeCondition condition;
  condition.name = definition.name;
  if (check_region(path + ".nodes", definition.nodes, false) && grid_complete_) {
    condition.nodes = nodes_in(model_.grid, definition.nodes, node_tolerance);
    if (is_empty(model_.grid, condition.nodes)) {
      violations_.add(path + ".nodes", "", "the region catches no node of the grid",
                      "enlarge the region; nodes lie at domain.lower + cell_size * (i, j, k)");
    }
  }
  if (const auto* fixed = std::get_if<Fixed>(&definition.condition)) {
    check_condition(path + ".fixed", *fixed, condition);
  } else if (const auto* prescribed = std::get_if<PrescribedVelocity>(&definition.condition)) {
    check_condition(path + ".prescribed_velocity", *prescribed, condition);
  } else {
    violations_.add(path, "", "no condition is given", "give fixed or prescribed_velocity");
  }
  model_.conditions.push_back(std::move(condition));
}

void Validator::check_condition(const std::string& path, const Fixed& fixed, NodeCondition& condition) {
  const Expression zero("0", "t", {});
  for (std::size_t i = 0; i < fixed.axes.size(); ++i) {
    if (fixed.axes[i] == Axis::unspecified) {
      violations_.add(indexed(path + ".axes", i), "", "AXIS_UNSPECIFIED is not an axis", "give X, Y or Z");
    } else if (const int axis = static_cast<int>(fixed.axes[i]) - static_cast<int>(Axis::x); axis >= axes()) {
      no_axis(indexed(path + ".axes", i), axis_names[static_cast<std::size_t>(axis)], axis);
    }
  }
  const auto holds = [&](Axis axis) {
    return fixed.axes.empty() || std::ranges::find(fixed.axes, axis) != fixed.axes.end();
  };
  if (holds(Axis::x)) condition.velocity_x = zero;
  if (axes() > 1 && holds(Axis::y)) condition.velocity_y = zero;
  if (axes() > 2 && holds(Axis::z)) condition.velocity_z = zero;
}

void Validator::check_condition(const std::string& path, const PrescribedVelocity& prescribed,
                                NodeCondition& condition) {
  const VectorExpression& velocity = prescribed.velocity;
  if (!velocity.x && !velocity.y && !velocity.z) {
    violations_.add(path + ".velocity", "", "no component is given", "give at least one");
  }
  const auto component = [&](const std::optional<std::string>& text, int axis, std::optional<Expression>& made) {
    const std::string place = path + ".velocity." + axis_names[static_cast<std::size_t>(axis)];
    if (text && axis < axes()) made = history_formula(place, *text);
    if (text && axis >= axes()) no_axis(place, *text, axis);
  };
  component(velocity.x, 0, condition.velocity_x);
  component(velocity.y, 1, condition.velocity_y);
  component(velocity.z, 2, condition.velocity_z);
}

}  // namespace trajan
