#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/selection.h"
#include "solver/model/validator.h"

namespace trajan {

namespace {

constexpr std::int32_t most_samples = 10'000'000;
constexpr std::int32_t default_snapshots = 10;

constexpr const char* field_remedy =
    "give POSITION, DISPLACEMENT, VELOCITY, STRESS, STRAIN, DEFORMATION_GRADIENT, PRESSURE or VON_MISES_STRESS";

std::int32_t nearest_smaller_divisor(std::int32_t of, std::int32_t most) {
  std::int32_t divisor = std::min(of, most);
  while (of % divisor != 0) --divisor;
  return divisor;
}

std::string statistic_name(Statistic statistic) {
  switch (statistic) {
    case Statistic::largest:
      return "largest";
    case Statistic::smallest:
      return "smallest";
    case Statistic::mean:
      break;
  }
  return "mean";
}

/// Whether any of these particles, in ascending order, is one of the body's.
bool holds_any(const Body& body, const std::vector<std::int64_t>& particles) {
  const auto first = std::ranges::lower_bound(particles, body.first_particle);
  return first != particles.end() && *first < body.first_particle + body.particles;
}

}  // namespace

void Validator::check_outputs() {
  const Outputs& outputs = scene_.outputs;
  const bool samples = violations_.within("outputs.samples", outputs.samples, 1, most_samples);
  clock_complete_ = clock_complete_ && samples;
  model_.outputs.samples = outputs.samples;
  if (samples) check_snapshots();
  check_snapshot_fields();
  if (!check_list("outputs.probes", outputs.probes)) return;
  for (std::size_t i = 0; i < outputs.probes.size(); ++i) {
    check_probe(indexed("outputs.probes", i), outputs.probes[i]);
  }
  check_reactions();
  columns_ = history_columns(model_);
  const double columns = static_cast<double>(columns_.size());
  if (samples && columns * outputs.samples > most_history_values) {
    violations_.add("outputs.samples", std::to_string(outputs.samples),
                    "too many rows for histories of " + number_text(columns) + " columns",
                    "give fewer samples or probes: at most 10^9 values in all");
  }
}

void Validator::check_reactions() {
  std::vector<std::string> names;
  for (const BoundaryCondition& condition : model_.conditions)
    if (!condition.name.empty()) names.push_back(condition.name);
  const std::vector<std::string>& asked = scene_.outputs.reactions;
  for (std::size_t i = 0; i < asked.size() && violations_.worth_a_hint(); ++i) {
    const std::string path = indexed("outputs.reactions", i);
    const auto found = std::ranges::find(model_.conditions, asked[i], &BoundaryCondition::name);
    const auto index = static_cast<std::size_t>(found - model_.conditions.begin());
    const auto body = body_index_.find(asked[i]);
    if (std::find(asked.begin(), asked.begin() + static_cast<std::ptrdiff_t>(i), asked[i]) !=
        asked.begin() + static_cast<std::ptrdiff_t>(i)) {
      violations_.add(path, asked[i], quoted(asked[i]) + " is asked for twice", "name each one once");
    } else if (asked[i].empty() || (found == model_.conditions.end() && body == body_index_.end())) {
      // One that is wrong itself is not reported again.
      const auto same = [&](const BoundaryDefinition& definition) { return definition.name == asked[i]; };
      const auto defined = std::ranges::find_if(scene_.boundaries, same);
      if (defined == scene_.boundaries.end())
        unknown_name(path, asked[i], "boundary condition", names);
      else if (std::holds_alternative<Periodic>(defined->condition))
        violations_.add(path, asked[i], "a periodic condition has no reaction", "leave it out");
    } else if (found == model_.conditions.end()) {
      check_contact_force(path, asked[i], body->second);
    } else {
      model_.outputs.reactions.push_back(index);
    }
  }
}

void Validator::check_contact_force(const std::string& path, const std::string& name, std::size_t body) {
  const std::vector<std::uint32_t>& fields = model_.contacts.field_of;
  const auto touches = [&](const BodyContact& contact) {
    return contact.bodies.empty() || std::ranges::count(contact.bodies, name) > 0;
  };
  if (std::ranges::none_of(scene_.contacts, touches))
    violations_.add(path, name, "no contact is defined for body " + quoted(name),
                    "name it in contacts, or ask for a boundary condition");
  else if (body < fields.size() && std::ranges::count(fields, fields[body]) > 1)
    violations_.add(path, name,
                    "other bodies touch the same ones as body " + quoted(name) +
                        " and not each other: they feel contact as one",
                    "ask for the force on what they touch, or let them touch each other");
  else
    model_.outputs.contact_forces.push_back(body);
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

void Validator::check_snapshot_fields() {
  const Outputs& outputs = scene_.outputs;
  check_fields("outputs.snapshot_fields", outputs.snapshot_fields);
  std::vector<std::size_t> bodies;
  for (std::size_t body = 0; body < model_.bodies.size(); ++body) {
    if (is_complete(body)) bodies.push_back(body);
  }
  if (!bodies.empty()) check_history("outputs.snapshot_history", outputs.snapshot_history, bodies, false);
  std::vector<Field> fields = outputs.snapshot_fields;
  std::erase_if(fields, [](Field field) { return field == Field::position || field == Field::velocity; });
  model_.outputs.snapshot_fields = recorded_fields(fields, outputs.snapshot_history);
}

bool Validator::check_fields(const std::string& path, const std::vector<Field>& fields) {
  bool good = true;
  for (std::size_t i = 0; i < fields.size() && violations_.worth_a_hint(); ++i) {
    if (fields[i] == Field::unspecified) {
      good = violations_.add(indexed(path, i), "", "FIELD_UNSPECIFIED is not a field", field_remedy);
    } else if (std::find(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(i), fields[i]) !=
               fields.begin() + static_cast<std::ptrdiff_t>(i)) {
      good = violations_.add(indexed(path, i), std::string(field_name(fields[i])),
                             quoted(field_name(fields[i])) + " is asked for twice", "name each field once");
    }
  }
  return good;
}

std::vector<RecordedField> Validator::recorded_fields(const std::vector<Field>& fields,
                                                      const std::vector<std::string>& history) const {
  std::vector<RecordedField> recorded;
  for (const Field field : fields) {
    recorded.push_back({field, std::string(field_name(field)), field_components(field, model_.dimension), {}});
  }
  for (const std::string& name : history) {
    recorded.push_back({Field::history, name, {}, {}});
    for (const Body& body : model_.bodies) recorded.back().history.push_back(history_place(body, name));
  }
  return recorded;
}

std::span<const HistoryVariable> Validator::history_of(const Body& body) const {
  const MaterialKind* kind =
      body.material < model_.materials.size() ? model_.materials[body.material].kind : nullptr;
  return kind == nullptr ? std::span<const HistoryVariable>() : kind->history;
}

int Validator::history_place(const Body& body, const std::string& name) const {
  const auto history = history_of(body);
  const auto found = std::ranges::find(history, name, &HistoryVariable::name);
  return found == history.end() ? -1 : static_cast<int>(found - history.begin());
}

bool Validator::check_history(const std::string& path, const std::vector<std::string>& history,
                              const std::vector<std::size_t>& bodies, bool in_all) {
  std::vector<std::string> known;
  for (const std::size_t body : bodies) {
    for (const HistoryVariable& variable : history_of(model_.bodies[body])) known.emplace_back(variable.name);
  }
  std::ranges::sort(known);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  bool good = true;
  for (std::size_t i = 0; i < history.size() && violations_.worth_a_hint(); ++i) {
    const std::string place = indexed(path, i);
    const auto lacks = [&](std::size_t body) { return history_place(model_.bodies[body], history[i]) < 0; };
    const auto without = std::ranges::find_if(bodies, lacks);
    if (std::find(history.begin(), history.begin() + static_cast<std::ptrdiff_t>(i), history[i]) !=
        history.begin() + static_cast<std::ptrdiff_t>(i)) {
      good = violations_.add(place, history[i], quoted(history[i]) + " is asked for twice", "name each once");
    } else if (known.empty()) {
      good = violations_.add(place, history[i], "the laws of these bodies remember nothing", "leave it out");
    } else if (!std::ranges::binary_search(known, history[i])) {
      unknown_name(place, history[i], "history variable", known);
      good = false;
    } else if (in_all && without != bodies.end()) {
      good = violations_.add(place, history[i],
                             "the law of body " + quoted(model_.bodies[*without].name) + " has no such variable",
                             "give a body whose law has it");
    }
  }
  return good;
}

void Validator::check_probe(const std::string& path, const ProbeDefinition& definition) {
  Probe probe;
  probe.name = definition.name;
  probe.statistic = definition.statistic;
  bool good = is_identifier(definition.name);
  if (definition.name == "energies" || definition.name == "momentum" || definition.name == "reactions") {
    good = violations_.add(path + ".name", definition.name,
                           quoted(definition.name) + " is the name of other histories", "choose another name");
  }
  good = check_fields(path + ".fields", definition.fields) && good;
  if (definition.fields.empty() && definition.history.empty())
    good = violations_.add(path + ".fields", "", "the list is empty", field_remedy);
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
    probe.particles = within_region(path + "." + statistic_name(definition.statistic), *region, bodies);
  } else {
    violations_.add(path, "", "no place is given", "give nearest, mean, largest or smallest");
  }
  std::erase_if(bodies, [&](std::size_t body) { return !holds_any(model_.bodies[body], probe.particles); });
  if (!bodies.empty()) good = check_history(path + ".history", definition.history, bodies, true) && good;
  probe.fields = recorded_fields(definition.fields, definition.history);
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
  const bool everywhere = std::holds_alternative<std::monostate>(region);
  if (bodies.empty() || (!everywhere && !check_region(path, region, false))) return {};
  for (const std::size_t index : bodies) {
    const Body& body = model_.bodies[index];
    selected_ += everywhere ? static_cast<double>(body.particles) : most_particles_in(body, region);
  }
  std::vector<std::int64_t> particles;
  if (selected_ > most_selected) {
    violations_.add(path, number_text(selected_) + " particles",
                    "there are too many particles in regions of probes",
                    "give smaller regions: at most 10^7 particles in all of them together");
    return particles;
  }
  for (const std::size_t index : bodies) {
    const Body& body = model_.bodies[index];
    if (everywhere) {
      for (std::int64_t i = 0; i < body.particles; ++i) particles.push_back(body.first_particle + i);
    } else {
      particles_in(body, region, particles);
    }
  }
  if (particles.empty()) {
    violations_.add(path, "", "the region catches no particle", "enlarge the region or move it into a body");
  }
  return particles;
}

}  // namespace trajan
