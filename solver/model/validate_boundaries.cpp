#include <algorithm>
#include <cmath>

#include "solver/model/geometry.h"
#include "solver/model/names.h"
#include "solver/model/overloaded.h"
#include "solver/model/selection.h"
#include "solver/model/surfaces.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

/// The nodes within a region to a tolerance in cells, clipped to the grid.
NodeRegion nodes_in(const Grid& grid, const Region& region, double tolerance) {
  NodeRegion nodes;
  const Box box = bounds(region);
  if (!std::holds_alternative<Box>(region)) nodes.shape = region;
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

/// Whether a row along x has a node in the region.
bool has_node(const Grid& grid, const NodeRegion& nodes, std::int64_t j, std::int64_t k, double tolerance) {
  const double y = grid.origin.y + static_cast<double>(j) * grid.cell;
  const double z = grid.origin.z + static_cast<double>(k) * grid.cell;
  for (const Span& span : spans(*nodes.shape, y, z, tolerance * grid.cell)) {
    const double first =
        std::max(static_cast<double>(nodes.i0), std::ceil((span.from - grid.origin.x) / grid.cell));
    const double last = std::min(static_cast<double>(nodes.i1), std::floor((span.to - grid.origin.x) / grid.cell));
    if (first <= last) return true;
  }
  return false;
}

/// The nodes of a face of the domain's box.
NodeRegion nodes_on(const Grid& grid, Edge face) {
  NodeRegion nodes{0, grid.cells_x, 0, grid.cells_y, 0, grid.cells_z, {}};
  std::int64_t* const ends[][2] = {{&nodes.i0, &nodes.i1}, {&nodes.j0, &nodes.j1}, {&nodes.k0, &nodes.k1}};
  const auto& [lower, upper] = ends[normal_axis(face)];
  (is_upper(face) ? *lower : *upper) = is_upper(face) ? *upper : *lower;
  return nodes;
}

}  // namespace

void Validator::check_boundaries() {
  check_periods();
  if (model_.dimension == Dimension::axisymmetric && grid_complete_ && model_.grid.origin.x == 0) {
    // Nothing crosses the axis.
    PrescribedMotion axis;
    axis.nodes = nodes_on(model_.grid, Edge::left);
    axis.components[0] = zero();
    model_.conditions.push_back({"", std::move(axis)});
  }
  if (!check_list("boundaries", scene_.boundaries)) return;
  for (std::size_t i = 0; i < scene_.boundaries.size(); ++i)
    check_boundary(indexed("boundaries", i), scene_.boundaries[i]);
}

void Validator::check_boundary(const std::string& path, const BoundaryDefinition& definition) {
  const auto check = Overloaded{
      [&](std::monostate) {
        violations_.add(path, "", "no condition is given", "give fixed, roller, symmetry or another condition");
      },
      [&](const Fixed& fixed) { add(definition, check_fixed(path, definition, fixed)); },
      [&](const Roller& roller) { add(definition, check_roller(path, definition, roller)); },
      [&](const Symmetry& symmetry) {
        refuse_nodes(path, definition, "symmetry");
        add(definition, check_symmetry(path + ".symmetry", symmetry));
      },
      [&](const PrescribedVelocity& prescribed) {
        add(definition,
            check_motion(path, definition, ".prescribed_velocity.velocity", prescribed.velocity, false));
      },
      [&](const PrescribedDisplacement& prescribed) {
        add(definition, check_motion(path, definition, ".prescribed_displacement.displacement",
                                     prescribed.displacement, true));
      },
      [&](const RigidPlane& plane) {
        refuse_nodes(path, definition, "rigid_plane");
        add(definition, check_plane(path + ".rigid_plane", plane));
      },
      [&](const RigidBall& ball) {
        refuse_nodes(path, definition, "rigid_ball");
        add(definition, check_ball(path + ".rigid_ball", ball));
      },
      [&](const Hinge& hinge) {
        refuse_nodes(path, definition, "hinge");
        add(definition, check_hinge(path + ".hinge", hinge));
      },
      [&](const Absorbing& absorbing) {
        refuse_nodes(path, definition, "absorbing");
        add(definition, check_absorbing(path + ".absorbing", absorbing));
      },
      [&](const Periodic&) { refuse_nodes(path, definition, "periodic"); }};
  std::visit(check, definition.condition);
}

template <class Kind>
void Validator::add(const BoundaryDefinition& definition, Kind kind) {
  model_.conditions.push_back({definition.name, std::move(kind)});
}

void Validator::refuse_nodes(const std::string& path, const BoundaryDefinition& definition,
                             const std::string& condition) {
  if (!std::holds_alternative<std::monostate>(definition.nodes))
    violations_.add(path + "." + (std::holds_alternative<Edge>(definition.nodes) ? "face" : "nodes"), "",
                    condition + " says itself where it is", "leave it out");
}

bool Validator::check_face(const std::string& path, Edge face) {
  if (face == Edge::unspecified)
    return violations_.add(path, "", "not given", "give LEFT, RIGHT, BOTTOM, TOP, BACK or FRONT");
  if (normal_axis(face) < axes()) return true;
  no_axis(path, "", normal_axis(face));
  return false;
}

NodeRegion Validator::check_nodes(const std::string& path, const BoundaryDefinition& definition) {
  if (const Edge* face = std::get_if<Edge>(&definition.nodes)) {
    if (!check_face(path + ".face", *face) || !grid_complete_) return {};
    check_solid_face(path + ".face", *face);
    return nodes_on(model_.grid, *face);
  }
  const Region* given = std::get_if<Region>(&definition.nodes);
  if (!check_region(path + ".nodes", given ? *given : Region{}, false) || !grid_complete_) return {};
  const NodeRegion nodes = nodes_in(model_.grid, *given, node_tolerance);
  if (is_empty(path + ".nodes", nodes))
    violations_.add(path + ".nodes", "", "the region catches no node of the grid",
                    "enlarge the region; nodes lie at domain.lower + cell_size * (i, j, k)");
  return nodes;
}

/// Rows are looked at until one has a node, the middle one first.
bool Validator::is_empty(const std::string& path, const NodeRegion& nodes) {
  if (nodes.i0 > nodes.i1 || nodes.j0 > nodes.j1 || nodes.k0 > nodes.k1) return true;
  if (!nodes.shape) return false;
  const double work = work_of_a_line(*nodes.shape);
  const auto has = [&](std::int64_t j, std::int64_t k) {
    counting_ += work;
    return has_node(model_.grid, nodes, j, k, node_tolerance);
  };
  if (has((nodes.j0 + nodes.j1) / 2, (nodes.k0 + nodes.k1) / 2)) return false;
  for (std::int64_t k = nodes.k0; k <= nodes.k1; ++k)
    for (std::int64_t j = nodes.j0; j <= nodes.j1; ++j) {
      if (has(j, k)) return false;
      if (counting_ <= most_counting) continue;
      violations_.add(path, "", "it takes too long to find its nodes", "give a simpler region or larger cells");
      return false;
    }
  return true;
}

bool Validator::check_axis(const std::string& path, Axis axis) {
  if (axis == Axis::unspecified)
    return violations_.add(path, "", "AXIS_UNSPECIFIED is not an axis", "give X, Y or Z");
  const int index = static_cast<int>(axis) - static_cast<int>(Axis::x);
  if (index < axes()) return true;
  no_axis(path, axis_names[static_cast<std::size_t>(index)], index);
  return false;
}

std::array<bool, 3> Validator::check_axes(const std::string& path, const std::vector<Axis>& given) {
  std::array<bool, 3> held{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes()); ++axis) held[axis] = given.empty();
  for (std::size_t i = 0; i < given.size(); ++i)
    if (check_axis(indexed(path, i), given[i]))
      held[static_cast<std::size_t>(given[i]) - static_cast<std::size_t>(Axis::x)] = true;
  return held;
}

PrescribedMotion Validator::check_motion(const std::string& path, const BoundaryDefinition& definition,
                                         const std::string& field, const VectorExpression& formulas,
                                         bool displacement) {
  PrescribedMotion motion{check_nodes(path, definition), displacement, {}};
  if (!formulas.x && !formulas.y && !formulas.z)
    violations_.add(path + field, "", "no component is given", "give at least one");
  const Grid& grid = model_.grid;
  const Vector at{grid.origin.x + grid.cell * static_cast<double>(motion.nodes.i0),
                  grid.origin.y + grid.cell * static_cast<double>(motion.nodes.j0),
                  grid.origin.z + grid.cell * static_cast<double>(motion.nodes.k0)};
  motion.components = motion_formulas(path + field, formulas, place_variables(), at);
  return motion;
}

PrescribedMotion Validator::check_fixed(const std::string& path, const BoundaryDefinition& definition,
                                        const Fixed& fixed) {
  PrescribedMotion motion{check_nodes(path, definition), false, {}};
  const std::array<bool, 3> held = check_axes(path + ".fixed.axes", fixed.axes);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (held[axis]) motion.components[axis] = zero();
  return motion;
}

PrescribedMotion Validator::check_roller(const std::string& path, const BoundaryDefinition& definition,
                                         const Roller& roller) {
  PrescribedMotion motion{check_nodes(path, definition), false, {}};
  Axis normal = roller.normal;
  if (const Edge* face = std::get_if<Edge>(&definition.nodes); face && *face != Edge::unspecified) {
    const auto of_face = static_cast<Axis>(static_cast<int>(Axis::x) + normal_axis(*face));
    if (normal != Axis::unspecified && normal != of_face)
      violations_.add(path + ".roller.normal", "", "not normal to the face", "leave it out");
    normal = of_face;
    if (normal_axis(*face) >= axes()) return motion;
  }
  if (check_axis(path + ".roller.normal", normal))
    motion.components[static_cast<std::size_t>(normal) - static_cast<std::size_t>(Axis::x)] = zero();
  return motion;
}

PrescribedMotion Validator::check_symmetry(const std::string& path, const Symmetry& symmetry) {
  PrescribedMotion motion;
  if (!check_face(path + ".face", symmetry.face) || !grid_complete_) return motion;
  check_solid_face(path + ".face", symmetry.face);
  motion.nodes = nodes_on(model_.grid, symmetry.face);
  motion.components[static_cast<std::size_t>(normal_axis(symmetry.face))] = zero();
  return motion;
}

}  // namespace trajan
