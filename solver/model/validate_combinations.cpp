#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"
#include "solver/schemes/scheme.h"
#include "solver/transfers/transfer.h"

/// Choices that are right each by itself and make no sense together.
namespace trajan {
namespace {

/// Two choices that exclude each other.
struct Exclusion {
  bool (*applies)(const Model&);
  const char* path;
  const char* problem;
  const char* remedy;
};

bool is_total(const Model& model) { return is_total_lagrangian(model.numerics.scheme); }
bool has_shapes(const Model& model, std::string_view name) { return model.numerics.shape_functions == name; }
bool has_order(const Model& model) { return find_transfer(model.numerics.transfer)->ordered; }
bool has_common_stencils(const Model& model) {
  return !has_shapes(model, "gimp") && !has_shapes(model, "cpgimp") && !has_shapes(model, "cpdi");
}
bool is_thin(const Model& model) {
  return model.dimension == Dimension::bar || model.dimension == Dimension::plane_stress;
}
bool shares_volume(const Model& model) { return model.numerics.locking_remedy == "mean_dilatation"; }
bool is_explicit(const Model& model) {
  return std::holds_alternative<ExplicitDynamics>(model.analysis) ||
         std::holds_alternative<Relaxation>(model.analysis);
}
/// Whether what particles bring to the grid is within the range of floats, small parts of it too.
bool fits_floats(const Model& model) {
  const auto fits = [](double value) { return value > 1e-28 && value < 1e35; };
  return std::ranges::all_of(model.bodies, [&](const Body& body) {
    const Material& material = model.materials[body.material];
    const double mass = material.density * body.particle_volume;
    const double speed = material.kind->wave_speed(material.parameters, material.density, model.dimension);
    return fits(mass) && fits(speed) && fits(mass * speed * speed / model.grid.cell);
  });
}
bool is_odd(std::int64_t cells) { return cells % 2 == 1; }

bool has_bsplines(const Model& model) { return model.numerics.shape_functions.ends_with("bspline"); }

constexpr Exclusion exclusions[] = {
    {[](const Model& m) {
       return m.numerics.scheme == "USL" && is_explicit(m) && has_bsplines(m) && !m.surface_loads.empty();
     },
     "numerics.scheme",
     "loads on surfaces reach nodes that B-splines give hardly any mass, whose velocities \"USL\" takes for "
     "strains: a "
     "bar's end moves up to a third too far",
     "choose \"MUSL\", or numerics.shape_functions: \"gimp\" or \"cpdi\""},
    {[](const Model& m) { return has_shapes(m, "bernstein") && !is_total(m); }, "numerics.shape_functions",
     "\"bernstein\" functions have kinks between their elements, which particles must not cross",
     "choose numerics.scheme: \"TLMPM\", in which they never do, or \"quadratic_bspline\""},
    {[](const Model& m) {
       return has_shapes(m, "bernstein") &&
              (is_odd(m.grid.cells_x) || is_odd(m.grid.cells_y) || is_odd(m.grid.cells_z));
     },
     "domain.upper",
     "elements of \"bernstein\" functions are two cells wide, and along an axis the cells are odd in number",
     "make the domain an even number of cells along every axis"},
    {[](const Model& m) { return (has_shapes(m, "cpgimp") || has_shapes(m, "cpdi")) && is_total(m); },
     "numerics.shape_functions",
     "in a total Lagrangian scheme shape functions see particles as they were at rest, which do not deform",
     "choose \"gimp\", which is the same there"},
    {[](const Model& m) { return has_shapes(m, "cpdi") && m.dimension == Dimension::axisymmetric; },
     "numerics.shape_functions", "domains of \"cpdi\" could reach across the axis, where there is nothing",
     "choose \"gimp\", \"cpgimp\" or B-splines"},
    {[](const Model& m) { return m.contacts.fields > 1 && is_total(m); }, "contacts",
     "in a total Lagrangian scheme bodies meet on the grid as they lay at rest, not where they have moved",
     "choose an updated Lagrangian numerics.scheme, for example \"MUSL\""},
    {[](const Model& m) { return m.numerics.flip_fraction && m.numerics.transfer != "FLIP"; },
     "numerics.flip_fraction", "only the transfer \"FLIP\" is a blend",
     "leave it out, or choose numerics.transfer: \"FLIP\""},
    {[](const Model& m) { return m.numerics.transfer_order && !has_order(m); }, "numerics.transfer_order",
     "only the transfers \"XPIC\" and \"FMPM\" have an order", "leave it out, or choose one of them"},
    {[](const Model& m) { return shares_volume(m) && is_explicit(m) && !is_total(m); }, "numerics.locking_remedy",
     "in explicit updated Lagrangian steps particles leave those with which they have shared their volume, and "
     "energy "
     "is lost",
     "choose numerics.scheme: \"TLMPM\", or an implicit analysis, for example quasi_static"},
    {[](const Model& m) { return shares_volume(m) && !has_common_stencils(m); }, "numerics.locking_remedy",
     "particles of one cell do not see the same nodes through shape functions that are as wide as particles",
     "leave it out, or choose \"linear\", \"bernstein\" or a B-spline"},
    {[](const Model& m) { return shares_volume(m) && is_thin(m); }, "numerics.locking_remedy",
     "where the thickness is free nothing holds the volume, and nothing locks", "leave it out"},
    {[](const Model& m) { return m.numerics.precision == float_precision && !is_explicit(m); },
     "numerics.precision", "implicit steps and modes solve equations, which need doubles",
     "leave it out, or choose an analysis by explicit steps, for example explicit_dynamics"},
    {[](const Model& m) { return m.numerics.precision == float_precision && !fits_floats(m); },
     "numerics.precision",
     "there are no floats as small or as large as this scene's masses, wave speeds or forces",
     "leave it out, or give the scene in other units"},
};

/// Whether a place is within a rigid body, or on it but for this much.
bool is_within(const RigidObstacle& obstacle, Vector at, double tolerance) {
  const Vector from = {at.x - obstacle.point.x, at.y - obstacle.point.y, at.z - obstacle.point.z};
  if (obstacle.ball) return std::hypot(from.x, from.y, from.z) - obstacle.radius <= tolerance;
  return from.x * obstacle.normal.x + from.y * obstacle.normal.y + from.z * obstacle.normal.z <= tolerance;
}

/// Whether a body lies at a rigid one from the start: whether that holds a corner of a particle's cell.
bool is_touched(const Model& model, const RigidObstacle& obstacle, double tolerance) {
  const Grid& grid = model.grid;
  const double h = grid.cell;
  const int corners = 1 << grid_axes(model.dimension);
  bool touched = false;
  for (const Body& body : model.bodies)
    body.lattice.for_each_point([&](std::int64_t, Vector p) {
      for (int corner = 0; corner < corners && !touched; ++corner) {
        const auto along = [&](double x, double origin, int axis) {
          return origin + h * (std::floor((x - origin) / h) + (corner >> axis & 1));
        };
        touched = is_within(
            obstacle, {along(p.x, grid.origin.x, 0), along(p.y, grid.origin.y, 1), along(p.z, grid.origin.z, 2)},
            tolerance);
      }
    });
  return touched;
}

}  // namespace

void Validator::check_combinations() {
  for (const Exclusion& exclusion : exclusions)
    if (exclusion.applies(model_)) violations_.add(exclusion.path, "", exclusion.problem, exclusion.remedy);
  if (is_total(model_)) check_rigid_bodies_at_rest();
}

/// In a total Lagrangian scheme nodes are where bodies lay at rest: what meets a rigid body later is not seen.
void Validator::check_rigid_bodies_at_rest() {
  if (std::ranges::any_of(model_.grid.periodic, [](bool periodic) { return periodic; })) return;
  for (const BoundaryCondition& condition : model_.conditions) {
    const auto* obstacle = std::get_if<RigidObstacle>(&condition.kind);
    if (obstacle == nullptr || is_touched(model_, *obstacle, node_tolerance * model_.grid.cell)) continue;
    if (std::ranges::any_of(obstacle->displacement, [](const auto& u) { return u.has_value(); })) continue;
    const auto place = std::ranges::find(scene_.boundaries, condition.name, &BoundaryDefinition::name);
    violations_.add(
        indexed("boundaries", static_cast<std::size_t>(place - scene_.boundaries.begin())), condition.name,
        "no body lies at it at the start, and a total Lagrangian scheme does not see what meets it later",
        "choose an updated Lagrangian numerics.scheme, for example \"MUSL\", or let them touch at first");
  }
}

}  // namespace trajan
