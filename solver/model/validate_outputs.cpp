#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/selection.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

constexpr std::int32_t most_samples = 10'000'000;
constexpr std::int32_t default_snapshots = 10;

std::int32_t nearest_smaller_divisor(std::int32_t of, std::int32_t most) {
  std::int32_t divisor = std::min(of, most);
  while (of % divisor != 0) --divisor;
  return divisor;
}

}  // namespace

void Validator::check_outputs() {
  const Outputs& outputs = scene_.outputs;
  const bool samples = violations_.within("outputs.samples", outputs.samples, 1, most_samples);
  clock_complete_ = clock_complete_ && samples;
  model_.outputs.samples = outputs.samples;
  if (samples) check_snapshots();
  check_fields("outputs.snapshot_fields", outputs.snapshot_fields);
  model_.outputs.snapshot_fields = outputs.snapshot_fields;
  if (!check_list("outputs.probes", outputs.probes)) return;
  for (std::size_t i = 0; i < outputs.probes.size(); ++i) {
    check_probe(indexed("outputs.probes", i), outputs.probes[i]);
  }
  columns_ = history_columns(model_);
  const double columns = static_cast<double>(columns_.size());
  if (samples && columns * outputs.samples > most_history_values) {
    violations_.add("outputs.samples", std::to_string(outputs.samples),
                    "too many rows for histories of " + number_text(columns) + " columns",
                    "give fewer samples or probes: at most 10^9 values in all");
  }
}

void Validator::check_snapshots() {
  const std::int32_t samples = scene_.outputs.samples;
  const std::int32_t snapshots =
      scene_.outputs.snapshots.value_or(nearest_smaller_divisor(samples, default_snapshots));
  if (snapshots == 0) return;
  if (snapshots < 0 || snapshots > samples) {
    violations_.add("outputs.snapshots", std::to_string(snapshots), "out of range",
                    "give 0, or a divisor of outputs.samples, " + std::to_string(samples));
  } else if (samples % snapshots != 0) {
    violations_.add("outputs.snapshots", std::to_string(snapshots),
                    "must divide outputs.samples, " + std::to_string(samples),
                    "give for example " + std::to_string(nearest_smaller_divisor(samples, snapshots)));
  } else {
    model_.outputs.samples_per_snapshot = samples / snapshots;
  }
}

bool Validator::check_fields(const std::string& path, const std::vector<Field>& fields) {
  bool good = true;
  for (std::size_t i = 0; i < fields.size() && violations_.worth_a_hint(); ++i) {
    if (fields[i] == Field::unspecified) {
      good = violations_.add(indexed(path, i), "", "FIELD_UNSPECIFIED is not a field",
                             "give POSITION, DISPLACEMENT, VELOCITY or STRESS");
    } else if (std::find(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(i), fields[i]) !=
               fields.begin() + static_cast<std::ptrdiff_t>(i)) {
      good = violations_.add(indexed(path, i), std::string(field_name(fields[i])),
                             quoted(field_name(fields[i])) + " is asked for twice", "name each field once");
    }
  }
  return good;
}

void Validator::check_probe(const std::string& path, const ProbeDefinition& definition) {
  Probe probe;
  probe.name = definition.name;
  probe.fields = definition.fields;
  bool good = is_identifier(definition.name);
  if (definition.name == "energies" || definition.name == "momentum") {
    good = violations_.add(path + ".name", definition.name,
                           quoted(definition.name) + " is the name of other histories", "choose another name");
  }
  good = check_fields(path + ".fields", definition.fields) && good;
  if (definition.fields.empty()) {
    good = violations_.add(path + ".fields", "", "the list is empty",
                           "give POSITION, DISPLACEMENT, VELOCITY or STRESS");
  }
  std::vector<std::size_t> bodies;
  bool complete = true;
  if (!definition.body.empty()) {
    if (const auto body = find_body(path + ".body", definition.body)) bodies.push_back(*body);
  } else {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) bodies.push_back(i);
  }
  for (const std::size_t body : bodies) complete = complete && is_complete(body);
  if (!complete) bodies.clear();
  if (const auto* place = std::get_if<Vector>(&definition.where)) {
    probe.particles = nearest(path + ".nearest", *place, bodies);
  } else if (const auto* region = std::get_if<Region>(&definition.where)) {
    probe.mean = true;
    probe.particles = within_region(path + ".mean", *region, bodies);
  } else {
    violations_.add(path, "", "no place is given", "give nearest or mean");
  }
  if (good) {
    model_.outputs.probes.push_back(std::move(probe));
  } else {
    broken_probes_.insert(definition.name);
  }
}

std::vector<std::int64_t> Validator::nearest(const std::string& path, Vector place,
                                             const std::vector<std::size_t>& bodies) {
  if (!check_vector(path, place) || bodies.empty()) return {};
  NearestParticle best = nearest_particle(model_.bodies[bodies.front()], place);
  for (const std::size_t body : bodies) {
    const NearestParticle other = nearest_particle(model_.bodies[body], place);
    if (other.distance < best.distance - node_tolerance * model_.grid.cell) best = other;
  }
  return {best.particle};
}

std::vector<std::int64_t> Validator::within_region(const std::string& path, const Region& region,
                                                   const std::vector<std::size_t>& bodies) {
  if (!check_region(path, region, false) || bodies.empty()) return {};
  for (const std::size_t body : bodies) selected_ += most_particles_in(model_.bodies[body], region);
  std::vector<std::int64_t> particles;
  if (selected_ > most_selected) {
    violations_.add(path, number_text(selected_) + " particles",
                    "there are too many particles in regions of probes",
                    "give smaller regions: at most 10^7 particles in all of them together");
    return particles;
  }
  for (const std::size_t body : bodies) particles_in(model_.bodies[body], region, particles);
  if (particles.empty()) {
    violations_.add(path, "", "the region catches no particle", "enlarge the region or move it into a body");
  }
  return particles;
}

}  // namespace trajan
