#include "solver/simulation/executor.h"

#include <algorithm>
#include <cmath>

#include "solver/schemes/schemes.h"
#include "solver/simulation/diverged.h"

namespace trajan {
namespace {

/// Nodes with less than this share of the lightest particle's mass carry nothing but rounding.
constexpr double least_mass_share = 1e-12;

constexpr unsigned bit(NodeValue value) { return 1u << value; }

/// Bits of the node quantities that a pass gathers.
unsigned gathered(Pass pass, double flip) {
  constexpr unsigned velocity = bit(node_velocity_x) | bit(node_velocity_y);
  constexpr unsigned acceleration = bit(node_acceleration_x) | bit(node_acceleration_y);
  constexpr unsigned mapped = bit(node_mapped_velocity_x) | bit(node_mapped_velocity_y);
  switch (pass) {
    case Pass::gather_acceleration:
      return acceleration | (flip < 1 ? velocity : 0u);
    case Pass::gather_motion:
      return velocity | mapped;
    default:
      return 0;
  }
}

}  // namespace

/// A chain of passes, resolved to stages for every body.
struct Executor::Chain {
  std::vector<Pass> passes;
  unsigned mask = 0;            ///< node quantities that are gathered
  int first_sum = 0, sums = 0;  ///< sums that are scattered
  std::vector<Stage> stages;    ///< of one body after the other
};

Executor::Executor(const Model& model, int threads)
    : model_(model),
      kernels_(kernels()),
      pool_(threads),
      bodies_(make_particles(model)),
      conditions_(model),
      loads_(model, find_scheme(model.numerics.scheme)->total_lagrangian) {
  sweep_.cell = model.grid.cell;
  sweep_.inverse_cell = 1 / model.grid.cell;
  sweep_.origin_x = sweep_.lower_x = model.grid.origin.x;
  sweep_.origin_y = sweep_.lower_y = model.grid.origin.y;
  sweep_.upper_x = sweep_.lower_x + model.grid.cell * static_cast<double>(model.grid.cells_x);
  sweep_.upper_y = sweep_.lower_y + model.grid.cell * static_cast<double>(model.grid.cells_y);
  sweep_.flip = model.numerics.flip_fraction;
  sweep_.sums = loads_.none() ? sums_without_loads : sum_count;
  lightest_particle_ = bodies_[0].constants.mass;
  for (const BodyParticles& body : bodies_) lightest_particle_ = std::min(lightest_particle_, body.constants.mass);
  account_ = !loads_.none() || model.damping > 0 || conditions_.work();
  for (int thread = 0; thread < threads; ++thread) {
    scratch_.push_back(std::make_unique<Scratch>());
    collected_.push_back(std::make_unique<NodeSums>());
  }
}

Executor::~Executor() = default;

void Executor::sort() {
  sort_into_tiles(model_.grid, bodies_, tiles_, sweep_.sums);
  ++sortings_;
  bind();
}

void Executor::bind() {
  conditions_.bind(tiles_);
  loads_.bind(bodies_, tiles_);
  shares_ = tiles_.shares(pool_.size());
  tile_work_.assign(tiles_.tiles().size(), 0.0);
  tile_dissipated_.assign(tiles_.tiles().size(), 0.0);
}

template <class Of>
void Executor::for_each_tile(Of&& of) {
  pool_.run([&](int thread) {
    for (std::size_t tile = shares_[static_cast<std::size_t>(thread)];
         tile < shares_[static_cast<std::size_t>(thread) + 1]; ++tile)
      of(tile, static_cast<std::size_t>(thread));
  });
}

void Executor::particles(std::initializer_list<Pass> passes) {
  for (Pass pass : passes) {
    if (pass == Pass::gather_motion) loads_.advect(tiles_, bodies_, node_mapped_velocity_x, times_.drift);
    noted_.push_back(pass);
  }
}

void Executor::finish() {
  if (noted_.empty()) return;
  // Whatever happens, these are done with: the chain has its own copy of them.
  const std::span<const Pass> passes = chain_of(noted_).passes;
  noted_.clear();
  run(passes);
}

Stage Executor::stage_of(Pass pass, const BodyParticles& body) const {
  const bool blend = sweep_.flip < 1;
  switch (pass) {
    case Pass::locate:
      return kernels_.locate;
    case Pass::force:
      return body.law->force;
    case Pass::scatter_state:
      return loads_.none() ? kernels_.scatter_state : kernels_.scatter_state_and_loads;
    case Pass::gather_acceleration:
      return blend ? kernels_.gather_acceleration_and_velocity : kernels_.gather_acceleration;
    case Pass::update_velocity:
      return blend ? kernels_.kick_and_blend : kernels_.kick;
    case Pass::kick:
      return kernels_.kick;
    case Pass::scatter_momentum:
      return kernels_.scatter_momentum;
    case Pass::gather_motion:
      return kernels_.gather_motion;
    case Pass::move:
      return kernels_.move;
    case Pass::displace:
      return kernels_.displace;
    case Pass::deform:
      return body.law->deform;
  }
  return nullptr;
}

const Executor::Chain& Executor::chain_of(std::span<const Pass> passes) {
  for (const auto& known : chains_)
    if (std::ranges::equal(known->passes, passes)) return *known;
  auto chain = std::make_unique<Chain>();
  chain->passes.assign(passes.begin(), passes.end());
  for (Pass pass : passes) {
    chain->mask |= gathered(pass, sweep_.flip);
    if (pass == Pass::scatter_state) chain->sums = sweep_.sums;
    if (pass == Pass::scatter_momentum) chain->first_sum = sum_momentum_x, chain->sums = 2;
  }
  for (const BodyParticles& body : bodies_)
    for (Pass pass : passes) chain->stages.push_back(stage_of(pass, body));
  chains_.push_back(std::move(chain));
  return *chains_.back();
}

void Executor::run(std::span<const Pass> passes) {
  const Chain& chain = chain_of(passes);
  for (auto& scratch : scratch_) scratch->trouble = {};
  for_each_tile([&](std::size_t tile, std::size_t thread) { run_tile(tile, chain, *scratch_[thread]); });
  Trouble trouble;
  for (const auto& scratch : scratch_) {
    trouble.left_window += scratch->trouble.left_window;
    trouble.left_domain += scratch->trouble.left_domain;
    trouble.moved_too_far += scratch->trouble.moved_too_far;
    trouble.inverted += scratch->trouble.inverted;
    trouble.unsolved += scratch->trouble.unsolved;
  }
  check(trouble);
  if (trouble.left_window == 0) return;
  // What has been scattered from clamped places is worthless; the particles themselves are right.
  sort();
  const auto last = std::find(passes.rbegin(), passes.rend(), Pass::locate);
  run(passes.subspan(static_cast<std::size_t>(last.base() - 1 - passes.begin())));
}

void Executor::run_tile(std::size_t index, const Chain& chain, Scratch& scratch) {
  const Tile& tile = tiles_.tiles()[index];
  if (tile.window < 0) return;
  if (chain.mask) {
    kernels_.load_window(scratch.window, tiles_.nodes_around(tile), chain.mask);
  }
  double* sums = tiles_.sums(index) + chain.first_sum * window_nodes;
  std::fill(sums, sums + chain.sums * window_nodes, 0.0);
  for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) {
    Block block = make_block(tile, tiles_.blocks()[b], scratch);
    block.sums = tiles_.sums(index);
    const Stage* stages = chain.stages.data() + tiles_.blocks()[b].body * chain.passes.size();
    for (std::size_t i = 0; i < chain.passes.size(); ++i) stages[i](block);
  }
}

Block Executor::make_block(const Tile& tile, const BlockRange& range, Scratch& scratch) const {
  const BodyParticles& body = bodies_[range.body];
  Block block;
  block.count = range.count;
  for (int a = 0; a < attribute_count; ++a)
    if (!body.arrays[a].empty()) block.arrays[a] = const_cast<double*>(body.arrays[a].data()) + range.begin;
  block.body = &body.constants;
  block.sweep = &sweep_;
  block.window_x = tile_side * static_cast<double>(tile.x) - 1;
  block.window_y = tile_side * static_cast<double>(tile.y) - 1;
  block.lowest_x = tile.cells.lowest_x;
  block.highest_x = tile.cells.highest_x;
  block.lowest_y = tile.cells.lowest_y;
  block.highest_y = tile.cells.highest_y;
  block.scratch = &scratch;
  return block;
}

void Executor::update_velocities(const StepTimes& times, double light_node) {
  loads_.accelerate(bodies_, times.time);
  finish();
  loads_.add_to(tiles_, bodies_, times.time);
  times_ = times;
  sweep_.kick = times.kick();
  sweep_.drift = times.drift;
  conditions_.evaluate(times.before, times.after, times.kick());
  for_each_tile([&](std::size_t index, std::size_t thread) {
    NodeBlock block;
    block.nodes = tiles_.nodes(index);
    block.sums = tiles_.sums_around(tiles_.tiles()[index]);
    block.sum_arrays = sweep_.sums;
    block.kick = times.kick();
    block.damping = model_.damping;
    block.least_mass = least_mass_share * lightest_particle_;
    block.collected = collected_[thread].get();
    kernels_.update_velocities(block);
    const double reactions = conditions_.prescribe(index, block.nodes, times.kick());
    if (light_node > 0) {
      block.light_mass = light_node * lightest_particle_;
      kernels_.calm_light_nodes(block);
      conditions_.prescribe_mapped(index, block.nodes);
    }
    if (!account_) return;
    kernels_.account(block);
    tile_work_[index] = block.work + reactions;
    tile_dissipated_[index] = block.dissipated;
  });
  if (!account_) return;
  for (double work : tile_work_) work_ += work;
  for (double dissipated : tile_dissipated_) dissipated_ += dissipated;
}

void Executor::map_velocities() {
  finish();
  for_each_tile([&](std::size_t index, std::size_t) {
    NodeBlock block;
    block.nodes = tiles_.nodes(index);
    block.sums = tiles_.sums_around(tiles_.tiles()[index]);
    block.least_mass = least_mass_share * lightest_particle_;
    kernels_.map_velocities(block);
    conditions_.prescribe_mapped(index, block.nodes);
  });
}

}  // namespace trajan
