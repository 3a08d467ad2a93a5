#include <algorithm>

#include "solver/simulation/simulation.h"

namespace trajan {
namespace {

/// Visits the particles of a body in the order of their numbers: visit(row of all particles, place in memory,
/// reference position).
template <class Visit>
void for_each_particle(const Model& model, const Executor& executor, std::uint32_t index, Visit&& visit) {
  const Body& body = model.bodies[index];
  const BodyParticles& particles = executor.bodies()[index];
  std::vector<std::uint32_t> slot_of(particles.size());
  for (std::uint32_t slot = 0; slot < particles.size(); ++slot) slot_of[particles.number[slot]] = slot;
  body.lattice.for_each_point([&](std::int64_t number, Vector at) {
    visit(static_cast<std::size_t>(body.first_particle + number),
          Slot{index, slot_of[static_cast<std::size_t>(number)]}, at);
  });
}

}  // namespace

Snapshot Simulation::snapshot() {
  const auto n = static_cast<std::size_t>(model_.particle_count());
  const auto axes = vector_components(model_.dimension);
  const RecordedField position{Field::position, "", axes, {}}, velocity{Field::velocity, "", axes, {}};
  Snapshot snapshot;
  snapshot.time = time();
  const auto record = [&](const RecordedField& field, std::vector<double>& values) {
    const std::size_t width = field.width();
    values.resize(width * n);
    for (std::uint32_t body = 0; body < model_.bodies.size(); ++body) {
      for_each_particle(model_, executor_, body, [&](std::size_t row, const Slot& slot, Vector reference) {
        std::array<double, most_components> value;
        fields_.read(field, slot, reference, value);
        std::copy_n(value.begin(), width, values.begin() + static_cast<std::ptrdiff_t>(row * width));
      });
    }
  };
  record(position, snapshot.position);
  record(velocity, snapshot.velocity);
  for (const RecordedField& field : model_.outputs.snapshot_fields) record(field, snapshot.fields.emplace_back());
  return snapshot;
}

}  // namespace trajan
