#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/selection.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

/// An edge of a box: the particles along it are at place(i, 0), its points at place(i, s), where s in
/// [-1, 1] goes over the part of the edge that belongs to particle i.
struct EdgeLine {
  const Body& body;
  Edge edge;

  bool vertical() const { return edge == Edge::left || edge == Edge::right; }
  bool upper() const { return edge == Edge::right || edge == Edge::top; }
  std::int64_t particles() const { return vertical() ? body.lattice.rows : body.lattice.columns; }
  double spacing() const { return vertical() ? body.lattice.spacing.y : body.lattice.spacing.x; }
  std::int64_t carrier(std::int64_t i) const {
    const Lattice& lattice = body.lattice;
    return vertical() ? box_particle(body, upper() ? lattice.columns - 1 : 0, i)
                      : box_particle(body, i, upper() ? lattice.rows - 1 : 0);
  }
  Vector place(std::int64_t i, double s) const {
    const Box& box = std::get<Box>(body.lattice.geometry);
    const Vector particle = vertical() ? body.lattice.point(0, i) : body.lattice.point(i, 0);
    if (vertical()) return {upper() ? box.upper.x : box.lower.x, particle.y + s * spacing() / 2};
    return {particle.x + s * spacing() / 2, upper() ? box.upper.y : box.lower.y};
  }
};

/// Index of the first time that is not after the one before it; 0 if all are.
std::size_t first_disorder(const std::vector<double>& times) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1])) return i;
  }
  return 0;
}

bool check_table(Violations& violations, const std::string& path, const Table& table) {
  if (table.times.empty())
    return violations.add(path + ".times", "", "the list is empty", "give at least one time and value");
  if (table.values.size() != table.times.size()) {
    return violations.add(path + ".values", std::to_string(table.values.size()) + " values",
                          "there are not as many values as times",
                          "give " + std::to_string(table.times.size()) + " values");
  }
  bool good = true;
  for (std::size_t i = 0; i < table.times.size(); ++i) {
    good = violations.finite(indexed(path + ".times", i), table.times[i]) && good;
    good = violations.finite(indexed(path + ".values", i), table.values[i]) && good;
  }
  const std::size_t disorder = first_disorder(table.times);
  if (!good || disorder == 0) return good;
  return violations.add(indexed(path + ".times", disorder), number_text(table.times[disorder]),
                        "not after the time before it", "give strictly increasing times");
}

}  // namespace

void Validator::check_loads() {
  if (!check_list("loads", scene_.loads)) return;
  for (std::size_t i = 0; i < scene_.loads.size(); ++i) check_load(indexed("loads", i), scene_.loads[i]);
}

void Validator::check_load(const std::string& path, const LoadDefinition& definition) {
  const TimeFunction time = time_function(path + ".time", definition.time).value_or(TimeFunction());
  if (const auto* point = std::get_if<PointForce>(&definition.kind)) {
    model_.surface_loads.push_back({definition.name, load_points(path + ".point_force", *point), time});
  } else if (const auto* edge = std::get_if<EdgeTraction>(&definition.kind)) {
    model_.surface_loads.push_back({definition.name, load_points(path + ".edge_traction", *edge), time});
  } else if (const auto* body = std::get_if<BodyForce>(&definition.kind)) {
    check_vector(path + ".body_force.acceleration", body->acceleration);
    model_.body_loads.push_back(
        {definition.name, body->acceleration, loaded_bodies(path + ".body_force", *body), time});
  } else {
    violations_.add(path, "", "no kind of load is given", "give point_force, edge_traction or body_force");
  }
}

std::vector<LoadPoint> Validator::load_points(const std::string& path, const PointForce& force) {
  const auto body = find_body(path + ".body", force.body);
  check_vector(path + ".force", force.force);
  const bool place = check_vector(path + ".position", force.position);
  if (!place || !body || !is_complete(*body)) return {};
  const Body& carrier = model_.bodies[*body];
  const Vector spacing = carrier.lattice.spacing;
  const double farthest = std::max(spacing.x, spacing.y) * (1 + node_tolerance);
  const double outside = distance_from(carrier.lattice.geometry, force.position);
  if (!(outside <= farthest)) {
    violations_.add(path + ".position", point_text(force.position, axes()),
                    number_text(outside) + " outside of body " + quoted(force.body),
                    "choose a place in the body or at most " + number_text(std::max(spacing.x, spacing.y)) +
                        " (one particle spacing) outside");
    return {};
  }
  return {{nearest_particle(carrier, force.position).particle, force.position, force.force}};
}

/// Two Gauss points on each particle's part of the edge: the resultant is exact for profiles up to the
/// third degree, its moment up to the second; for others the error is of fourth order in the spacing.
std::vector<LoadPoint> Validator::load_points(const std::string& path, const EdgeTraction& traction) {
  const auto body = find_body(path + ".body", traction.body);
  check_vector(path + ".traction", traction.traction);
  if (traction.edge == Edge::unspecified) {
    violations_.add(path + ".edge", "", "not given", "give LEFT, RIGHT, BOTTOM or TOP");
  }
  const bool box = !body || std::holds_alternative<Box>(scene_.bodies[*body].geometry);
  if (!box) {
    violations_.add(path + ".body", traction.body,
                    quoted(traction.body) + " is not a box and has no straight edges",
                    "choose a body whose geometry is a box");
  }
  const bool usable = body && box && is_complete(*body);
  const Vector somewhere = usable ? model_.bodies[*body].lattice.first : Vector{};
  const auto profile =
      formula(path + ".profile", traction.profile.empty() ? "1" : traction.profile, place_variables(), somewhere);
  if (!usable || !profile || traction.edge == Edge::unspecified) return {};

  const EdgeLine line{model_.bodies[*body], traction.edge};
  load_points_ += 2 * static_cast<double>(line.particles());
  if (load_points_ > most_load_points) {
    violations_.add(path + ".edge", std::to_string(line.particles()) + " particles",
                    "there are too many particles along loaded edges", "give larger cells");
    return {};
  }
  const double weight = line.spacing() / 2 * model_.thickness;
  std::vector<LoadPoint> points;
  for (std::int64_t i = 0; i < line.particles(); ++i) {
    for (const double s : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
      const Vector place = line.place(i, s);
      const double share = weight * (*profile)(place, 0);
      if (!std::isfinite(share)) {
        violations_.add(path + ".profile", traction.profile,
                        "the formula is not finite at " + point_text(place, axes()),
                        "give a formula that is finite along the edge");
        return {};
      }
      points.push_back({line.carrier(i), place, {share * traction.traction.x, share * traction.traction.y}});
    }
  }
  return points;
}

std::vector<std::size_t> Validator::loaded_bodies(const std::string& path, const BodyForce& force) {
  std::vector<std::size_t> bodies;
  if (force.bodies.size() > most_entries) {
    violations_.add(path + ".bodies", std::to_string(force.bodies.size()) + " entries", "the list is too long",
                    "give at most " + std::to_string(most_entries));
    return bodies;
  }
  for (std::size_t i = 0; i < force.bodies.size(); ++i) {
    const auto body = find_body(indexed(path + ".bodies", i), force.bodies[i]);
    if (!body) continue;
    if (std::ranges::find(bodies, *body) != bodies.end()) {
      violations_.add(indexed(path + ".bodies", i), force.bodies[i], quoted(force.bodies[i]) + " is named twice",
                      "name each body once");
    }
    bodies.push_back(*body);
  }
  for (std::size_t i = 0; force.bodies.empty() && i < model_.bodies.size(); ++i) bodies.push_back(i);
  return bodies;
}

std::optional<TimeFunction> Validator::time_function(const std::string& path,
                                                     const TimeFunctionDefinition& definition) {
  if (const auto* constant = std::get_if<double>(&definition)) {
    violations_.finite(path + ".constant", *constant);
    return TimeFunction(*constant);
  }
  if (const auto* ramp = std::get_if<Ramp>(&definition)) {
    violations_.finite(path + ".ramp.start", ramp->start);
    violations_.positive(path + ".ramp.duration", ramp->duration);
    return TimeFunction(*ramp);
  }
  if (const auto* sine = std::get_if<Sine>(&definition)) {
    violations_.positive(path + ".sine.frequency", sine->frequency);
    violations_.finite(path + ".sine.phase", sine->phase);
    return TimeFunction(*sine);
  }
  if (const auto* table = std::get_if<Table>(&definition)) {
    if (!check_table(violations_, path + ".table", *table)) return std::nullopt;
    return TimeFunction(*table);
  }
  if (auto expression = history_formula(path + ".expression", std::get<std::string>(definition))) {
    return TimeFunction(std::move(*expression));
  }
  return std::nullopt;
}

}  // namespace trajan
