#include <algorithm>
#include <cmath>

#include "solver/model/geometry.h"
#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

Box grid_box(const Grid& grid) {
  return {grid.origin,
          {grid.origin.x + static_cast<double>(grid.cells_x) * grid.cell,
           grid.origin.y + static_cast<double>(grid.cells_y) * grid.cell,
           grid.origin.z + static_cast<double>(grid.cells_z) * grid.cell}};
}

double particle_volume(const Lattice& lattice, int axes, double thickness) {
  double volume = lattice.spacing.x * thickness;
  if (axes > 1) volume *= lattice.spacing.y;
  if (axes > 2) volume *= lattice.spacing.z;
  return volume;
}

/// Into which shape functions cut it, along an axis.
int parts_of_a_cell(const Scene& scene) { return scene.numerics.shape_functions == "quadratic_bspline" ? 2 : 1; }

}  // namespace

std::string Validator::box_text(const Box& box) const {
  return point_text(box.lower, axes()) + " to " + point_text(box.upper, axes());
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
  if (definition.particle_layout == ParticleLayout::unspecified)
    violations_.add(path + ".particle_layout", "", "there is no such layout", "choose UNIFORM or GAUSS");
  const bool filled = side && geometry && grid_complete_ && fill_body(path, definition, body);
  Vector place;
  if (filled) {
    place = body.lattice.point_of(body.particles / 2);
  }
  field(path + ".initial_velocity", definition.initial_velocity, place_variables(), place,
        {&body.velocity_x, &body.velocity_y, &body.velocity_z});
  if (material != materials.end()) check_initial_state(path, definition, body, place);
  return filled;
}

bool Validator::fill_body(const std::string& path, const BodyDefinition& definition, Body& body) {
  const Grid& grid = model_.grid;
  const Region& geometry = definition.geometry;
  const Box outer = bounds(geometry);
  const double slack = node_tolerance * grid.cell;
  const Box domain = grid_box(grid);
  const Box allowed = {{domain.lower.x - slack, domain.lower.y - slack, domain.lower.z - slack},
                       {domain.upper.x + slack, domain.upper.y + slack, domain.upper.z + slack}};
  for (int axis = 0; axis < axes(); ++axis) {
    const double thickness = outer.upper.*component[axis] - outer.lower.*component[axis];
    if (thickness >= slack || thickness < 0) continue;  // parts that do not meet have negative bounds
    return violations_.add(
        path + ".geometry", box_text(outer),
        std::string("along ") + axis_names[axis] + " the body is thinner than a billionth of a cell",
        "give a thicker body or smaller cells");
  }
  if (!is_above(allowed.lower, outer.lower, false) || !is_above(outer.upper, allowed.upper, false)) {
    return violations_.add(path + ".geometry", box_text(outer), "the body reaches out of the domain",
                           "stay within " + box_text(domain) + " or enlarge the domain");
  }
  const LatticeSize size = lattice_size(geometry, grid.cell, definition.particles_per_cell_side, axes());
  counting_ += size.work;
  const bool box = std::holds_alternative<Box>(geometry);
  if (!(size.points <= (box ? most_particles : most_in_box)) || !(counting_ <= most_counting))
    return too_many(path, size.points);
  body.lattice = make_lattice(geometry, grid.origin, grid.cell, definition.particles_per_cell_side, axes());
  body.lattice.number_points();
  if (definition.particle_layout == ParticleLayout::gauss) {
    if (!check_gauss_layout(path + ".particle_layout", definition)) return false;
    body.lattice.place_at_gauss_points(definition.particles_per_cell_side / parts_of_a_cell(scene_));
  }
  body.particles = body.lattice.count();
  const double particles = static_cast<double>(body.particles);
  if (particles + static_cast<double>(body.first_particle) > most_particles) {
    body.particles = 0;
    return too_many(path, particles);
  }
  if (body.particles == 0) {
    return violations_.add(path + ".geometry", box_text(outer), "the body is so small that no particle lies in it",
                           "give a larger body, smaller cells or more particles per cell");
  }
  body.particle_volume = particle_volume(body.lattice, axes(), model_.thickness);
  if (!(std::isfinite(body.particle_volume) && body.particle_volume > 0)) {
    return violations_.add(path + ".geometry", "particle volume " + number_text(body.particle_volume),
                           "its size gives particles without a finite volume", "give units of less extreme size");
  }
  return true;
}

bool Validator::check_gauss_layout(const std::string& path, const BodyDefinition& definition) {
  const auto refuse = [&](const std::string& problem, const std::string& remedy) {
    return violations_.add(path, "GAUSS", problem, remedy + ", or choose UNIFORM");
  };
  bool good = true;
  if (std::holds_alternative<ExplicitDynamics>(scene_.analysis.kind) ||
      std::holds_alternative<Relaxation>(scene_.analysis.kind))
    good = refuse("explicit steps take the particles of a body for equally heavy",
                  "choose an analysis that solves for displacements, for example modal");
  else if (scene_.numerics.scheme != "TLMPM")
    good = refuse("in the updated configuration particles leave the places that their weights belong to",
                  "choose numerics.scheme: \"TLMPM\"");
  if (scene_.numerics.shape_functions == "gimp")
    good = refuse("\"gimp\" takes particles for boxes of one size",
                  "choose numerics.shape_functions: \"linear\", \"bernstein\" or a B-spline");
  if (definition.particles_per_cell_side % parts_of_a_cell(scene_) != 0)
    good =
        refuse("\"quadratic_bspline\" functions change in the middle of cells, and the points fill halves of them",
               "give an even number of particles_per_cell_side");
  const auto* box = std::get_if<Box>(&definition.geometry);
  if (!box) return refuse("the points belong to whole cells, and only a box is made of such", "give a box");
  for (int axis = 0; axis < axes(); ++axis)
    for (const Vector* side : {&box->lower, &box->upper}) {
      const double cells = ((*side).*component[axis] - model_.grid.origin.*component[axis]) / model_.grid.cell;
      if (std::abs(cells - std::round(cells)) <= node_tolerance) continue;
      return refuse(
          std::string("along ") + axis_names[axis] + " the box cuts cells, and the points fill whole ones",
          "give sides that lie between cells");
    }
  return good;
}

bool Validator::too_many(const std::string& path, double particles) {
  return violations_.add(path, number_text(std::round(particles)) + " particles", "there are too many particles",
                         "give larger cells, fewer particles per cell or fewer shapes: at most 10^9 particles in "
                         "the scene");
}

std::optional<std::size_t> Checks::find_body(const std::string& path, const std::string& name) {
  const auto found = body_index_.find(name);
  if (found != body_index_.end()) return found->second;
  std::vector<std::string> names;
  if (violations_.worth_a_hint()) {
    for (const BodyDefinition& body : scene_.bodies) names.push_back(body.name);
  }
  unknown_name(path, name, "body", names);
  return std::nullopt;
}

std::vector<std::size_t> Checks::named_bodies(const std::string& path, const std::vector<std::string>& names) {
  std::vector<std::size_t> bodies;
  if (names.size() > most_entries) {
    violations_.add(path, std::to_string(names.size()) + " entries", "the list is too long",
                    "give at most " + std::to_string(most_entries));
    return bodies;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto body = find_body(indexed(path, i), names[i]);
    if (!body) continue;
    if (std::ranges::find(bodies, *body) != bodies.end()) {
      violations_.add(indexed(path, i), names[i], quoted(names[i]) + " is named twice", "name each body once");
    }
    bodies.push_back(*body);
  }
  for (std::size_t i = 0; names.empty() && i < model_.bodies.size(); ++i) bodies.push_back(i);
  return bodies;
}

bool Checks::is_complete(std::size_t body) const { return body < body_complete_.size() && body_complete_[body]; }

}  // namespace trajan
