#include <algorithm>
#include <cmath>

#include "solver/implicit/steppers.h"
#include "solver/schemes/schemes.h"
#include "solver/simulation/checkpoint_array.h"
#include "solver/simulation/simulation.h"

/// Particles are saved in their present order, with the tiles they are in: what is added up next is then
/// added up in the same order as if nothing had happened.
namespace trajan {
namespace {

std::string array_name(std::size_t body, std::string_view what) {
  return "body" + std::to_string(body) + "." + std::string(what);
}

std::vector<std::int32_t> pack(const Tiles& tiles) {
  std::vector<std::int32_t> packed;
  for (const Tile& tile : tiles.tiles()) {
    if (tile.first_block == tile.last_block) continue;
    for (const TileIndex& part : {tile.at, tile.cells.lowest, tile.cells.highest})
      packed.insert(packed.end(), part.begin(), part.end());
    packed.push_back(static_cast<std::int32_t>(tile.last_block - tile.first_block));
  }
  return packed;
}

std::vector<std::int64_t> pack(std::span<const BlockRange> blocks) {
  std::vector<std::int64_t> packed;
  for (const BlockRange& block : blocks) packed.insert(packed.end(), {block.begin, block.count, block.body});
  return packed;
}

void unpack(const Checkpoint& checkpoint, const std::vector<BodyParticles>& bodies, Tiles& tiles) {
  std::vector<BlockRange> blocks;
  const auto& b = checkpoint_array<std::int64_t>(checkpoint, "blocks");
  for (std::size_t i = 0; i + 3 <= b.size(); i += 3)
    blocks.push_back({static_cast<std::uint32_t>(b[i]), static_cast<std::uint16_t>(b[i + 1]),
                      static_cast<std::uint16_t>(b[i + 2])});
  std::vector<OccupiedTile> occupied;
  std::vector<std::uint32_t> blocks_of;
  std::size_t block = 0;
  const auto& t = checkpoint_array<std::int32_t>(checkpoint, "tiles");
  for (std::size_t i = 0; i + 10 <= t.size(); i += 10) {
    const auto part = [&](std::size_t from) { return TileIndex{t[i + from], t[i + from + 1], t[i + from + 2]}; };
    occupied.push_back({part(0), bodies[blocks[block].body].field, {part(3), part(6)}});
    blocks_of.push_back(static_cast<std::uint32_t>(t[i + 9]));
    block += blocks_of.back();
  }
  tiles.rebuild(occupied, std::move(blocks), blocks_of);
}

std::vector<double> surface_points(const std::vector<Riders*>& all) {
  std::vector<double> packed;
  for (Riders* riders : all) packed.insert(packed.end(), riders->state().begin(), riders->state().end());
  return packed;
}

std::vector<double> pack(std::span<const Reaction> reactions) {
  std::vector<double> packed;
  for (const Reaction& r : reactions)
    packed.insert(packed.end(), {r.work, r.dissipated, r.impulse[0], r.impulse[1], r.impulse[2]});
  return packed;
}

std::vector<Reaction> unpack_reactions(const std::vector<double>& packed) {
  std::vector<Reaction> reactions;
  for (std::size_t i = 0; i + 5 <= packed.size(); i += 5)
    reactions.push_back({packed[i], packed[i + 1], {packed[i + 2], packed[i + 3], packed[i + 4]}});
  return reactions;
}

void restore(const std::vector<double>& packed, const std::vector<Riders*>& all) {
  auto from = packed.begin();
  for (Riders* riders : all) {
    std::copy_n(from, riders->state().size(), riders->state().begin());
    from += static_cast<std::ptrdiff_t>(riders->state().size());
  }
}

}  // namespace

Checkpoint Simulation::save() {
  Checkpoint checkpoint;
  checkpoint.sample = sample_;
  checkpoint.step = steps_;
  checkpoint.time = time();
  for (std::size_t b = 0; b < executor_.bodies().size(); ++b) {
    const BodyParticles& body = executor_.bodies()[b];
    for (Attribute a : body.present) {
      const std::vector<float>& floats = body.floats[static_cast<std::size_t>(a)];
      // Floats as doubles, which they are exactly.
      checkpoint.arrays.push_back({array_name(b, attribute_name(a)),
                                   floats.empty() ? body[a] : std::vector<double>(floats.begin(), floats.end())});
    }
    checkpoint.arrays.push_back(
        {array_name(b, "number"), std::vector<std::int64_t>(body.number.begin(), body.number.end())});
  }
  checkpoint.arrays.push_back({"tiles", pack(executor_.tiles())});
  checkpoint.arrays.push_back({"blocks", pack(executor_.tiles().blocks())});
  const ParticleOrder& order = executor_.order();
  const bool drift = executor_.tiles().layout().margin == Margin::one_cell;
  checkpoint.arrays.push_back({"order", std::vector<std::int64_t>{order.sorted, order.now, drift}});
  checkpoint.arrays.push_back({"surface_points", surface_points(executor_.riders())});
  const Account& account = executor_.account();
  checkpoint.arrays.push_back({"reactions", pack(account.reactions())});
  const Exchanged& exchanged = account.exchanged();
  checkpoint.arrays.push_back(
      {"energies", std::vector<double>{exchanged.work, exchanged.dissipated, exchanged.contact, initial_energy_,
                                       largest_energy_, largest_input_, largest_internal_energy_}});
  checkpoint.arrays.push_back({"angular_momentum", angular_momentum_.save()});
  if (stepper_) stepper_->save(checkpoint);
  return checkpoint;
}

Simulation::Simulation(const Model& model, int threads, const Checkpoint& checkpoint)
    : model_(model),
      scheme_(*find_scheme(model.numerics.scheme)),
      executor_(model, threads),
      fields_(model, executor_),
      coherence_(model, executor_),
      angular_momentum_(model, executor_) {
  for (std::size_t b = 0; b < executor_.bodies().size(); ++b) {
    BodyParticles& body = executor_.bodies()[b];
    for (Attribute a : body.present) {
      const auto& saved = checkpoint_array<double>(checkpoint, array_name(b, attribute_name(a)));
      std::vector<float>& floats = body.floats[static_cast<std::size_t>(a)];
      if (floats.empty()) body[a] = saved;
      std::ranges::transform(floats, saved, floats.begin(),
                             [](float, double value) { return static_cast<float>(value); });
    }
    const auto& numbers = checkpoint_array<std::int64_t>(checkpoint, array_name(b, "number"));
    body.number.assign(numbers.begin(), numbers.end());
  }
  const auto& order = checkpoint_array<std::int64_t>(checkpoint, "order");
  if (order.at(2) != 0) executor_.expect_drift();
  unpack(checkpoint, executor_.bodies(), executor_.tiles());
  restore(checkpoint_array<double>(checkpoint, "surface_points"), executor_.riders());
  executor_.bind();
  executor_.order() = {order[0], order[1]};
  stepper_ = make_stepper(model, executor_, &checkpoint);
  const auto& energies = checkpoint_array<double>(checkpoint, "energies");
  executor_.account().restore({energies[0], energies[1], energies[2]});
  executor_.account().restore(unpack_reactions(checkpoint_array<double>(checkpoint, "reactions")));
  initial_energy_ = energies[3];
  largest_energy_ = energies[4];
  largest_input_ = energies[5];
  largest_internal_energy_ = energies[6];
  angular_momentum_.restore(checkpoint_array<double>(checkpoint, "angular_momentum"));
  sample_ = checkpoint.sample;
  steps_ = checkpoint.step;
  coherence_.resume(steps_);
  totals_ = executor_.totals();
  measure();
}

}  // namespace trajan
