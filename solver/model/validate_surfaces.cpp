#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/selection.h"
#include "solver/model/surfaces.h"
#include "solver/model/validator.h"

namespace trajan {
namespace {

/// Rows of particles that are looked at to find those nearest to a surface's points: some seconds. Near a body a
/// search sees a few dozen of them, far from it all.
constexpr double most_search_work = 1e8;

/// Shares of the largest component of an acoustic tensor that are rounding.
constexpr double rounding = 1e-12;

}  // namespace

std::vector<SurfacePoint> Validator::check_surface(const std::string& path, const Surface& surface) {
  const auto body = find_body(path + ".body", surface.body);
  bool usable = body && is_complete(*body);
  const bool limited = !std::holds_alternative<std::monostate>(surface.within);
  if (limited) usable = check_region(path + ".within", surface.within, false) && usable;
  std::vector<SurfacePoint> points;
  if (const Edge* edge = std::get_if<Edge>(&surface.part)) {
    points = check_edge(path, surface.body, usable ? body : std::nullopt, *edge);
  } else if (const Disc* rim = std::get_if<Disc>(&surface.part)) {
    points = check_rim(path + ".rim", usable ? body : std::nullopt, *rim);
  } else {
    violations_.add(path, "", "no part of the surface is given", "give edge or rim");
  }
  if (!limited || !usable || points.empty()) return points;
  const double slack = node_tolerance * model_.grid.cell;
  std::erase_if(points, [&](const SurfacePoint& p) { return distance_from(surface.within, p.position) > slack; });
  if (points.empty())
    violations_.add(path + ".within", "", "the region catches nothing of the surface", "enlarge the region");
  return points;
}

std::vector<SurfacePoint> Validator::check_edge(const std::string& path, const std::string& name,
                                                std::optional<std::size_t> body, Edge edge) {
  const bool face = check_face(path + ".edge", edge);
  if (!body) return {};
  const bool polygon = std::holds_alternative<Polygon>(scene_.bodies[*body].geometry);
  if (!polygon && !std::holds_alternative<Box>(scene_.bodies[*body].geometry)) {
    violations_.add(path + ".body", name, quoted(name) + " has no straight edges",
                    "choose a body whose geometry is a box or a polygon");
    return {};
  }
  if (!face) return {};
  const Body& carrier = model_.bodies[*body];
  const double count = count_edge_points(carrier, edge, axes());
  load_points_ += count;
  const auto refuse = [&]() -> std::vector<SurfacePoint> {
    violations_.add(path + ".edge", number_text(count) + " points",
                    "there are too many particles along edges with loads and conditions", "give larger cells");
    return {};
  };
  if (load_points_ > most_load_points) return refuse();
  if (!polygon) return edge_points(model_, carrier, edge);
  SearchBudget budget{most_search_work};
  std::vector<SurfacePoint> points = polygon_edge_points(model_, carrier, edge, budget);
  if (budget.rows < 0) return refuse();
  if (points.empty())
    violations_.add(path + ".edge", "", "no side of the polygon lies along this side of the box around it",
                    "choose another edge");
  return points;
}

std::vector<SurfacePoint> Validator::check_rim(const std::string& path, std::optional<std::size_t> body,
                                               const Disc& rim) {
  const bool centre = check_vector(path + ".centre", rim.centre);
  if (!violations_.positive(path + ".radius", rim.radius) || !centre || !body) return {};
  if (axes() == 1) {
    violations_.add(path, "", "a bar has no rim", "give an edge");
    return {};
  }
  const Body& carrier = model_.bodies[*body];
  const double count = count_rim_points(carrier, rim, axes());
  load_points_ += count;
  SearchBudget budget{most_search_work};
  std::vector<SurfacePoint> points;
  if (load_points_ <= most_load_points) points = rim_points(model_, carrier, rim, budget);
  if (!(load_points_ <= most_load_points) || budget.rows < 0) {
    violations_.add(path, number_text(count) + " points", "there are too many particles along the rim",
                    "give larger cells");
    return {};
  }
  if (points.empty())
    violations_.add(path, "", "no part of the body's surface lies on it",
                    "give the centre and radius of the body's own rim or hole");
  return points;
}

HeldSurface Validator::check_hinge(const std::string& path, const Hinge& hinge) {
  HeldSurface held;
  if (hinge.kind == HingeKind::unspecified) violations_.add(path + ".kind", "", "not given", "give WHOLE or MEAN");
  held.mean = hinge.kind == HingeKind::mean;
  held.held = check_axes(path + ".axes", hinge.axes);
  held.displacement = motion_formulas(path + ".displacement", hinge.displacement);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (held.displacement[axis] && !held.held[axis])
      violations_.add(path + ".displacement." + axis_names[axis], held.displacement[axis]->text(),
                      "this component is not held", "add it to axes, or leave it out");
  held.points = check_surface(path + ".surface", hinge.surface);
  held.normal = surface_normal(path + ".surface", hinge.surface);
  return held;
}

AbsorbingSurface Validator::check_absorbing(const std::string& path, const Absorbing& absorbing) {
  AbsorbingSurface surface;
  surface.points = check_surface(path + ".surface", absorbing.surface);
  surface.normal = surface_normal(path + ".surface", absorbing.surface);
  const auto body = body_index_.find(absorbing.surface.body);
  if (body == body_index_.end() || !is_complete(body->second)) return surface;
  if (model_.bodies[body->second].material >= model_.materials.size()) return surface;
  const Material& material = model_.materials[model_.bodies[body->second].material];
  if (!material.kind) return surface;
  const auto n = static_cast<std::size_t>(axes());
  std::array<double, 9> tensor{};
  material.kind->acoustic_tensor(material.parameters, material.density, model_.dimension, surface.normal, tensor);
  const double largest = *std::ranges::max_element(tensor);
  bool inclined = false;
  for (std::size_t i = 0; i < n * n; ++i)
    if (i % n == i / n)
      surface.impedance[i % n] = std::sqrt(material.density * std::max(0.0, tensor[i]));
    else
      inclined = inclined || std::abs(tensor[i]) > rounding * largest;
  if (inclined)
    violations_.add(
        path + ".surface", "",
        "the material's axes are inclined to the edge, at which no wave moves along or across it alone",
        "choose an edge along the material's axes, or turn these");
  return surface;
}

int Validator::surface_normal(const std::string& path, const Surface& surface) {
  const Edge* edge = std::get_if<Edge>(&surface.part);
  if (edge) return *edge == Edge::unspecified ? 0 : normal_axis(*edge);
  if (std::holds_alternative<Disc>(surface.part))
    violations_.add(path + ".rim", "", "this condition needs a straight edge", "give an edge");
  return 0;
}

}  // namespace trajan
