#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/selection.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

double largest_spacing(const Lattice& lattice, int axes) {
  double spacing = lattice.spacing.x;
  if (axes > 1) spacing = std::max(spacing, lattice.spacing.y);
  if (axes > 2) spacing = std::max(spacing, lattice.spacing.z);
  return spacing;
}

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
  SurfaceLoad load;
  load.name = definition.name;
  load.time = time_function(path + ".time", definition.time).value_or(TimeFunction());
  if (const auto* point = std::get_if<PointForce>(&definition.kind)) {
    load.points = load_points(path + ".point_force", *point);
  } else if (const auto* edge = std::get_if<EdgeTraction>(&definition.kind)) {
    load.points = load_points(path + ".edge_traction", *edge);
  } else if (const auto* pressure = std::get_if<Pressure>(&definition.kind)) {
    load.points = load_points(path + ".pressure", *pressure);
    load.follows = pressure->follows;
  } else if (const auto* body = std::get_if<BodyForce>(&definition.kind)) {
    check_vector(path + ".body_force.acceleration", body->acceleration);
    model_.body_loads.push_back(body_load(path + ".body_force", *body));
    model_.body_loads.back().name = definition.name;
    model_.body_loads.back().time = load.time;
    return;
  } else {
    violations_.add(path, "", "no kind of load is given",
                    "give point_force, edge_traction, pressure or body_force");
    return;
  }
  model_.surface_loads.push_back(std::move(load));
}

std::vector<LoadPoint> Validator::load_points(const std::string& path, const PointForce& force) {
  const auto body = find_body(path + ".body", force.body);
  check_vector(path + ".force", force.force);
  const bool place = check_vector(path + ".position", force.position);
  if (!place || !body || !is_complete(*body)) return {};
  const Body& carrier = model_.bodies[*body];
  const double spacing = largest_spacing(carrier.lattice, axes());
  const double outside = distance_from(carrier.lattice.geometry, force.position);
  if (!(outside <= spacing * (1 + node_tolerance))) {
    violations_.add(
        path + ".position", point_text(force.position, axes()),
        number_text(outside) + " outside of body " + quoted(force.body),
        "choose a place in the body or at most " + number_text(spacing) + " (one particle spacing) outside");
    return {};
  }
  LoadPoint point;
  point.carrier = nearest_particle(carrier, force.position).particle;
  point.position = force.position;
  point.force = force.force;
  return {point};
}

std::vector<LoadPoint> Validator::load_points(const std::string& path, const EdgeTraction& traction) {
  check_vector(path + ".traction", traction.traction);
  const auto points = check_surface(path, {traction.body, traction.edge, traction.within});
  std::vector<LoadPoint> loaded;
  for (const auto& [point, share] : with_profile(path + ".profile", traction.profile, points)) {
    loaded.push_back({point, {}, 0});
    loaded.back().force = {share * traction.traction.x, share * traction.traction.y, share * traction.traction.z};
  }
  return loaded;
}

std::vector<LoadPoint> Validator::load_points(const std::string& path, const Pressure& pressure) {
  violations_.finite(path + ".pressure", pressure.pressure);
  const auto points = check_surface(path + ".surface", pressure.surface);
  std::vector<LoadPoint> loaded;
  for (const auto& [point, share] : with_profile(path + ".profile", pressure.profile, points)) {
    const auto& [s, t] = point.tangents;
    const Vector n{s.y * t.z - s.z * t.y, s.z * t.x - s.x * t.z, s.x * t.y - s.y * t.x};
    const double force = -pressure.pressure * share / std::hypot(n.x, n.y, n.z);
    loaded.push_back({point, {force * n.x, force * n.y, force * n.z}, pressure.pressure * share / point.area});
  }
  return loaded;
}

std::vector<std::pair<SurfacePoint, double>> Validator::with_profile(const std::string& path,
                                                                     const std::string& profile,
                                                                     const std::vector<SurfacePoint>& points) {
  const Vector somewhere = points.empty() ? Vector{} : points.front().position;
  const auto factor = formula(path, profile.empty() ? "1" : profile, place_variables(), somewhere);
  if (!factor) return {};
  std::vector<std::pair<SurfacePoint, double>> shares;
  for (const SurfacePoint& point : points) {
    // On the axis of an axisymmetric scene there is nothing to load.
    if (!(point.area > 0)) continue;
    const double share = point.area * (*factor)(point.position, 0);
    if (!std::isfinite(share)) {
      violations_.add(path, profile, "the formula is not finite at " + point_text(point.position, axes()),
                      "give a formula that is finite along the edge");
      return {};
    }
    shares.emplace_back(point, share);
  }
  return shares;
}

BodyLoad Validator::body_load(const std::string& path, const BodyForce& force) {
  BodyLoad load;
  load.acceleration = force.acceleration;
  load.bodies = named_bodies(path + ".bodies", force.bodies);
  load.reference = force.reference;
  const bool given = force.field.x || force.field.y || force.field.z;
  if (!given) return load;
  const Vector& uniform = force.acceleration;
  if (uniform.x != 0 || uniform.y != 0 || uniform.z != 0) {
    violations_.add(path + ".field", "", "acceleration is given as well", "give one of them");
  }
  Vector place;
  if (!load.bodies.empty() && is_complete(load.bodies.front()))
    place = model_.bodies[load.bodies.front()].lattice.point_of(0);
  field(path + ".field", force.field, place_variables() + "t", place,
        {&load.field[0], &load.field[1], &load.field[2]});
  return load;
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
  const std::string place = path + ".expression";
  if (auto expression = history_formula(place, std::get<std::string>(definition)))
    return TimeFunction(Formula(std::move(*expression), place, true));
  return std::nullopt;
}

}  // namespace trajan
