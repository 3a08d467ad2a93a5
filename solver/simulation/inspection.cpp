#include <algorithm>
#include <cmath>

#include "solver/simulation/diverged.h"
#include "solver/simulation/fastest_particle.h"

/// Looking at particles: totals, stresses, and what went wrong.
namespace trajan {

Totals Executor::totals() {
  finish();
  tile_totals_.assign(tiles_.tiles().size(), {});
  loop_.for_each([&](std::size_t index, std::size_t thread) {
    const Tile& tile = tiles_.tiles()[index];
    for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) {
      Block block = make_block(tile, tiles_.blocks()[b], *scratch_[thread]);
      motion_.law_exchange.widen(block);
      motion_.measure(block, tile_totals_[index]);
      bodies_[tiles_.blocks()[b].body].law->measure(block, tile_totals_[index]);
    }
  });
  Totals all;
  for (const Totals& tile : tile_totals_) {
    all.kinetic_energy += tile.kinetic_energy;
    all.strain_energy += tile.strain_energy;
    all.dissipated_energy += tile.dissipated_energy;
    for (int axis = 0; axis < axes_; ++axis) all.momentum[axis] += tile.momentum[axis];
    if (!(tile.squared_speed <= all.squared_speed)) all.squared_speed = tile.squared_speed;
    if (!(tile.squared_wave_speed <= all.squared_wave_speed)) all.squared_wave_speed = tile.squared_wave_speed;
  }
  return all;
}

void Executor::visit(const std::function<void(Block&, std::size_t, std::size_t)>& of) {
  loop_.for_each([&](std::size_t index, std::size_t thread) {
    const Tile& tile = tiles_.tiles()[index];
    for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) {
      Block block = make_block(tile, tiles_.blocks()[b], *scratch_[thread]);
      of(block, b, index);
    }
  });
}

void Executor::stress(const Slot& slot, double* out) const {
  std::array<double*, 6> components;
  for (std::size_t c = 0; c < components.size(); ++c) components[c] = out + c;
  const BlockRange one{slot.index, 1, static_cast<std::uint16_t>(slot.body)};
  Block block = make_block(tiles_.tiles()[0], one, *scratch_[0]);
  motion_.law_exchange.widen(block);
  bodies_[slot.body].law->stress(block, components.data());
}

void Executor::check(const Trouble& trouble) const {
  if (trouble.inverted)
    diverge("a particle's deformation gradient has lost its positive determinant",
            "take a smaller numerics.time_step_fraction, or particles and cells of a better resolution");
  if (trouble.unsolved)
    diverge("no stretch across the plane or bar was found that frees a particle of the stress across it",
            "take a smaller numerics.time_step_fraction, or a material that bears such a deformation");
  if (trouble.moved_too_far)
    diverge(particle_text(model_, worst_particle()) +
                " moved more than one cell in a step, or its velocity is not a finite number",
            "take a smaller numerics.time_step_fraction; if that does not help, check loads and boundaries");
  if (trouble.left_domain)
    diverge(particle_text(model_, worst_particle()) + " left the domain",
            "enlarge domain.lower and domain.upper (empty space costs nothing), or hold the body by a boundary");
}

void Executor::diverge(const std::string& cause, const std::string& remedy) const {
  Divergence divergence;
  divergence.step = times_.step;
  divergence.time = times_.time;
  divergence.particle = worst_particle();
  divergence.cause = cause;
  divergence.remedy = remedy;
  // Nodes of nearly no mass accelerate without bound where stress is updated from their velocities.
  if (model_.numerics.scheme == "USL" && remedy.find("MUSL") == std::string::npos)
    divergence.remedy += ", or numerics.scheme: \"MUSL\"";
  throw Diverged(divergence);
}

std::int64_t Executor::worst_particle() const {
  double worst = -1;
  std::int64_t particle = -1;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const BodyParticles& body = bodies_[b];
    for (std::size_t i = 0; i < body.size(); ++i) {
      double out = 0, squared_speed = 0, sum = 0;
      for (int axis = 0; axis < axes_; ++axis) {
        const std::vector<double>& moved = body.component(Attribute::displacement_x, axis);
        const double x = body.component(Attribute::position_x, axis)[i] + (moved.empty() ? 0.0 : moved[i]);
        const double v = body.value(Attribute::velocity_x, axis, i);
        out = std::max({out, sweep_.lower[axis] - x, x - sweep_.upper[axis]});
        squared_speed += v * v;
        sum += x + v;
      }
      // Not finite before outside before fast.
      double badness = std::sqrt(squared_speed);
      if (out > 0) badness = 1e200 * (1 + out / sweep_.cell);
      if (!std::isfinite(sum)) badness = HUGE_VAL;
      if (badness <= worst) continue;
      worst = badness;
      particle = model_.bodies[b].first_particle + body.number[i];
    }
  }
  return particle;
}

std::vector<Riders*> Executor::riders() {
  std::vector<Riders*> riders = conditions_.riders();
  for (Riders& of_load : loads_.riders()) riders.push_back(&of_load);
  return riders;
}

std::size_t Executor::memory() const {
  std::size_t bytes = tiles_.memory() + collected_.size() * sizeof(NodeSums);
  for (const auto& scratch : scratch_) bytes += scratch->memory();
  for (const BodyParticles& body : bodies_) {
    bytes += body.number.capacity() * sizeof(std::uint32_t);
    for (const std::vector<double>& array : body.arrays) bytes += array.capacity() * sizeof(double);
    for (const std::vector<float>& array : body.floats) bytes += array.capacity() * sizeof(float);
  }
  return bytes;
}

}  // namespace trajan
