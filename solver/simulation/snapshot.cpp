#include "solver/schemes/schemes.h"
#include "solver/simulation/simulation.h"

namespace trajan {
namespace {

/// Writes a body's values, by slot, to the rows of its particles' numbers.
void put(const Body& body, const BodyParticles& particles, const std::vector<double>& values,
         std::size_t component, std::size_t components, std::vector<double>& out) {
  const auto first = static_cast<std::size_t>(body.first_particle);
  for (std::size_t i = 0; i < particles.size(); ++i)
    out[(first + particles.number[i]) * components + component] = values[i];
}

}  // namespace

Snapshot Simulation::snapshot() {
  const auto n = static_cast<std::size_t>(model_.particle_count());
  Snapshot snapshot;
  snapshot.time = time();
  snapshot.position.resize(2 * n);
  snapshot.velocity.resize(2 * n);
  std::vector<double> displacement;
  bool wants_displacement = false;
  for (Field field : model_.outputs.snapshot_fields) wants_displacement |= field == Field::displacement;
  if (wants_displacement) displacement.resize(2 * n);

  for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
    const Body& body = model_.bodies[b];
    const BodyParticles& particles = executor_.bodies()[b];
    put(body, particles, particles[Attribute::position_x], 0, 2, snapshot.position);
    put(body, particles, particles[Attribute::position_y], 1, 2, snapshot.position);
    put(body, particles, particles[Attribute::velocity_x], 0, 2, snapshot.velocity);
    put(body, particles, particles[Attribute::velocity_y], 1, 2, snapshot.velocity);
    if (scheme_.total_lagrangian) {
      for (std::size_t i = 0; i < particles.size(); ++i) {
        const std::size_t row = static_cast<std::size_t>(body.first_particle) + particles.number[i];
        snapshot.position[2 * row] += particles[Attribute::displacement_x][i];
        snapshot.position[2 * row + 1] += particles[Attribute::displacement_y][i];
      }
    }
    if (!wants_displacement) continue;
    body.lattice.for_each_point([&](std::int64_t point, Vector at) {
      const auto number = static_cast<std::uint32_t>(point);
      const std::size_t row = static_cast<std::size_t>(body.first_particle) + number;
      displacement[2 * row] = snapshot.position[2 * row] - at.x;
      displacement[2 * row + 1] = snapshot.position[2 * row + 1] - at.y;
    });
  }
  for (Field field : model_.outputs.snapshot_fields) {
    if (field == Field::displacement) snapshot.fields.emplace_back(field, displacement);
    if (field != Field::stress) continue;
    std::vector<double> stress(4 * n);
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
      const std::array<std::vector<double>, 4> components = executor_.stress(b);
      for (std::size_t c = 0; c < 4; ++c)
        put(model_.bodies[b], executor_.bodies()[b], components[c], c, 4, stress);
    }
    snapshot.fields.emplace_back(field, std::move(stress));
  }
  return snapshot;
}

}  // namespace trajan
