#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/selection.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

Box bounds(const Region& region) {
  if (const Box* box = std::get_if<Box>(&region)) return *box;
  const Disc& disc = std::get<Disc>(region);
  return {{disc.centre.x - disc.radius, disc.centre.y - disc.radius},
          {disc.centre.x + disc.radius, disc.centre.y + disc.radius}};
}

std::string box_text(const Box& box) { return point_text(box.lower) + " to " + point_text(box.upper); }

double particle_volume(const Lattice& lattice, double thickness) {
  if (const Box* box = std::get_if<Box>(&lattice.geometry)) {
    const double area = (box->upper.x - box->lower.x) * (box->upper.y - box->lower.y);
    return area / static_cast<double>(lattice.columns * lattice.rows) * thickness;
  }
  return lattice.spacing.x * lattice.spacing.y * thickness;
}

}  // namespace

bool Validator::check_region(const std::string& path, const Region& region, bool solid) {
  if (const Box* box = std::get_if<Box>(&region)) {
    bool good = violations_.finite(path + ".box.lower", box->lower);
    good = violations_.finite(path + ".box.upper", box->upper) && good;
    if (!good) return false;
    const double width = box->upper.x - box->lower.x, height = box->upper.y - box->lower.y;
    if (solid ? width > 0 && height > 0 : width >= 0 && height >= 0) return true;
    return violations_.add(
        path + ".box.upper", point_text(box->upper),
        "not above and to the right of lower, " + point_text(box->lower),
        solid ? "give upper.x > lower.x and upper.y > lower.y" : "give upper.x >= lower.x and upper.y >= lower.y");
  }
  if (const Disc* disc = std::get_if<Disc>(&region)) {
    const bool centre = violations_.finite(path + ".disc.centre", disc->centre);
    return violations_.positive(path + ".disc.radius", disc->radius) && centre;
  }
  return violations_.add(path, "", "no shape is given", "give a box or a disc");
}

void Validator::check_bodies() {
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) body_index_.emplace(scene_.bodies[i].name, i);
  if (scene_.bodies.empty()) violations_.add("bodies", "", "there is no body", "define at least one");
  if (!check_list("bodies", scene_.bodies)) return;
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    Body& body = model_.bodies.emplace_back();
    const std::int64_t before = i == 0 ? 0 : model_.bodies[i - 1].first_particle + model_.bodies[i - 1].particles;
    body.first_particle = before;
    body_complete_.push_back(check_body(indexed("bodies", i), scene_.bodies[i], body));
  }
}

bool Validator::check_body(const std::string& path, const BodyDefinition& definition, Body& body) {
  body.name = definition.name;
  std::vector<std::string> materials;
  for (const MaterialDefinition& material : scene_.materials) materials.push_back(material.name);
  const auto material = std::ranges::find(materials, definition.material);
  if (material == materials.end()) unknown_name(path + ".material", definition.material, "material", materials);
  body.material = static_cast<std::size_t>(material - materials.begin());
  const bool side =
      violations_.within(path + ".particles_per_cell_side", definition.particles_per_cell_side, 1, 16);
  const bool geometry = check_region(path + ".geometry", definition.geometry, true);
  const bool filled = side && geometry && grid_complete_ && fill_body(path, definition, body);
  Vector place;
  if (filled)
    place = body.lattice.point(body.lattice.columns_in_row(body.lattice.rows / 2).begin, body.lattice.rows / 2);
  const std::string velocity = path + ".initial_velocity";
  if (const auto& x = definition.initial_velocity.x) body.velocity_x = formula(velocity + ".x", *x, "xy", place);
  if (const auto& y = definition.initial_velocity.y) body.velocity_y = formula(velocity + ".y", *y, "xy", place);
  return filled;
}

bool Validator::fill_body(const std::string& path, const BodyDefinition& definition, Body& body) {
  const Grid& grid = model_.grid;
  const Region& geometry = definition.geometry;
  const Box outer = bounds(geometry);
  const double slack = node_tolerance * grid.cell;
  const Vector upper = {grid.origin.x + static_cast<double>(grid.cells_x) * grid.cell,
                        grid.origin.y + static_cast<double>(grid.cells_y) * grid.cell};
  if (outer.lower.x < grid.origin.x - slack || outer.lower.y < grid.origin.y - slack ||
      outer.upper.x > upper.x + slack || outer.upper.y > upper.y + slack) {
    return violations_.add(path + ".geometry", box_text(outer), "the body reaches out of the domain",
                           "stay within " + box_text({grid.origin, upper}) + " or enlarge the domain");
  }
  const double points = estimated_points(geometry, grid.cell, definition.particles_per_cell_side);
  if (!(points + static_cast<double>(body.first_particle) <= most_particles)) {
    return violations_.add(path, number_text(std::round(points)) + " particles", "there are too many particles",
                           "give larger cells or fewer particles per cell: at most 10^9 particles in the scene");
  }
  body.lattice = make_lattice(geometry, grid.origin, grid.cell, definition.particles_per_cell_side);
  body.particles = body.lattice.count();
  if (body.particles == 0) {
    return violations_.add(path + ".geometry", box_text(outer), "the body is so small that no particle lies in it",
                           "give a larger body, smaller cells or more particles per cell");
  }
  body.particle_volume = particle_volume(body.lattice, model_.thickness);
  const bool good_thickness = std::isfinite(model_.thickness) && model_.thickness > 0;
  if (good_thickness && !(std::isfinite(body.particle_volume) && body.particle_volume > 0)) {
    return violations_.add(path + ".geometry", "particle volume " + number_text(body.particle_volume),
                           "its size gives particles without a finite volume", "give units of less extreme size");
  }
  return true;
}

std::optional<std::size_t> Validator::find_body(const std::string& path, const std::string& name) {
  const auto found = body_index_.find(name);
  if (found != body_index_.end()) return found->second;
  std::vector<std::string> names;
  if (violations_.worth_a_hint()) {
    for (const BodyDefinition& body : scene_.bodies) names.push_back(body.name);
  }
  unknown_name(path, name, "body", names);
  return std::nullopt;
}

bool Validator::is_complete(std::size_t body) const {
  return body < body_complete_.size() && body_complete_[body];
}

}  // namespace trajan
