#include "solver/simulation/executor.h"

#include <algorithm>
#include <cmath>

#include "solver/schemes/schemes.h"
#include "solver/simulation/diverged.h"

namespace trajan {
namespace {

/// Nodes with less than this share of the lightest particle's mass carry nothing but rounding.
constexpr double least_mass_share = 1e-12;

/// Of the step's drift by which laws deform.
void take_half(Block& block) { block.scratch->deform_share = 0.5; }
void take_whole(Block& block) { block.scratch->deform_share = 1; }

}  // namespace

/// A chain of passes, resolved to stages for every body.
struct Executor::Chain {
  std::vector<Pass> passes;
  unsigned mask = 0;                       ///< node quantities that are gathered
  int first_sum = 0, sums = 0;             ///< sums that are scattered
  std::vector<std::vector<Stage>> stages;  ///< by body
};

Executor::Executor(const Model& model, int threads)
    : model_(model),
      axes_(grid_axes(model.dimension)),
      kernels_(kernels()),
      motion_(kernels_.motion[axes_ - 1]),
      transfer_(*kernels_.transfer(model.numerics.shape_functions, model.dimension)),
      pool_(threads),
      bodies_(make_particles(model)),
      conditions_(model),
      loads_(model),
      tiles_(transfer_.layout, quantities(node_vectors, axes_),
             quantities(loads_.none() ? sum_load : sum_vectors, axes_)) {
  sweep_.cell = model.grid.cell;
  sweep_.inverse_cell = 1 / model.grid.cell;
  const double origin[] = {model.grid.origin.x, model.grid.origin.y, model.grid.origin.z};
  const std::int64_t cells[] = {model.grid.cells_x, model.grid.cells_y, model.grid.cells_z};
  for (int axis = 0; axis < axes_; ++axis) {
    sweep_.origin[axis] = sweep_.lower[axis] = origin[axis];
    sweep_.faces[axis] = static_cast<double>(cells[axis]);
    sweep_.upper[axis] = origin[axis] + model.grid.cell * sweep_.faces[axis];
  }
  sweep_.flip = model.numerics.flip_fraction.value_or(1);
  lightest_particle_ = lightest_particle(bodies_);
  account_ = !loads_.none() || model.damping > 0 || conditions_.work();
  const auto window = static_cast<std::size_t>(quantities(node_vectors, axes_) * transfer_.window_copies *
                                               transfer_.layout.window_nodes);
  for (int thread = 0; thread < threads; ++thread) {
    scratch_.push_back(std::make_unique<Scratch>());
    windows_.emplace_back(window, 0.0);
    scratch_.back()->window = windows_.back().data();
    stencils_.emplace_back(static_cast<std::size_t>(transfer_.stencil_doubles), 0.0);
    scratch_.back()->stencils = stencils_.back().data();
  }
}

Executor::~Executor() = default;

void Executor::sort() {
  sort_into_tiles(model_.grid, bodies_, tiles_);
  ++sortings_;
  bind();
}

void Executor::bind() {
  or_diverge([&] { conditions_.bind(bodies_, tiles_); });
  loads_.bind(bodies_, tiles_);
  // Conditions on surfaces act between two passes over the tiles, of which the second needs what the first found.
  const std::size_t tiles = tiles_.tiles().size();
  collected_.resize(conditions_.on_surfaces() ? tiles : scratch_.size());
  shares_ = tiles_.shares(pool_.size());
  tile_reactions_.assign(tiles, {});
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
  // Loads that depend on the place need particles to be there before a step begins.
  if (loads_.follow_particles() && std::ranges::find(passes, Pass::scatter_state) != passes.end()) finish();
  for (Pass pass : passes) {
    if (pass == Pass::move || pass == Pass::displace) {
      loads_.advect(tiles_, bodies_, times_.drift);
      conditions_.advect(tiles_, bodies_, times_.drift);
    }
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

std::vector<Stage> Executor::stages_of(Pass pass, const BodyParticles& body) const {
  const bool blend = sweep_.flip < 1, hoop = model_.dimension == Dimension::axisymmetric;
  std::vector<Stage> stages;
  switch (pass) {
    case Pass::locate:
      return {transfer_.locate};
    case Pass::force:
      return {body.law->force};
    case Pass::scatter_state:
      stages = {transfer_.scatter_state};
      if (hoop) stages.push_back(transfer_.scatter_hoop);
      if (!loads_.none()) stages.insert(stages.end(), {motion_.find_loads, transfer_.scatter_loads});
      return stages;
    case Pass::gather_acceleration:
      stages = {transfer_.gather_acceleration};
      if (blend) stages.push_back(transfer_.gather_velocity);
      return stages;
    case Pass::update_velocity:
      return {blend ? motion_.kick_and_blend : motion_.kick};
    case Pass::kick:
      return {motion_.kick};
    case Pass::scatter_momentum:
      return {transfer_.scatter_momentum};
    case Pass::scatter_motion:
      return {transfer_.scatter_mass, transfer_.scatter_momentum};
    case Pass::gather_velocity:
      return {transfer_.gather_velocity};
    case Pass::gather_gradient:
      stages = {transfer_.gather_gradient};
      if (hoop) stages.push_back(transfer_.gather_hoop);
      return stages;
    case Pass::gather_motion:
      stages = {transfer_.gather_motion};
      if (hoop) stages.push_back(transfer_.gather_hoop);
      return stages;
    case Pass::move:
      return {motion_.move};
    case Pass::displace:
      return {motion_.displace};
    case Pass::deform:
      return deform_stages(body);
    case Pass::deform_by_half:
      stages = deform_stages(body);
      stages.insert(stages.begin(), take_half);
      stages.push_back(take_whole);
      return stages;
  }
  return stages;
}

std::vector<Stage> Executor::deform_stages(const BodyParticles& body) const {
  if (body.law->track == nullptr || body[Attribute::deformation_xx].empty()) return {body.law->deform};
  return {body.law->deform, body.law->track};
}

/// Bits of the node quantities that a pass gathers.
unsigned Executor::gathered(Pass pass) const {
  const auto bits = [this](NodeVector vector) { return ((1u << axes_) - 1) << quantity(vector, 0, axes_); };
  switch (pass) {
    case Pass::gather_acceleration:
      return bits(node_acceleration) | (sweep_.flip < 1 ? bits(node_velocity) : 0u);
    case Pass::gather_velocity:
      return bits(node_velocity);
    case Pass::gather_gradient:
      return bits(node_mapped_velocity);
    case Pass::gather_motion:
      return bits(node_velocity) | bits(node_mapped_velocity);
    default:
      return 0;
  }
}

const Executor::Chain& Executor::chain_of(std::span<const Pass> passes) {
  for (const auto& known : chains_)
    if (std::ranges::equal(known->passes, passes)) return *known;
  auto chain = std::make_unique<Chain>();
  chain->passes.assign(passes.begin(), passes.end());
  for (Pass pass : passes) {
    chain->mask |= gathered(pass);
    if (pass == Pass::scatter_state) chain->sums = tiles_.sum_quantities();
    if (pass == Pass::scatter_motion) chain->sums = quantities(1, axes_);
    if (pass == Pass::scatter_momentum) {
      chain->first_sum = quantity(sum_momentum, 0, axes_);
      chain->sums = axes_;
    }
  }
  for (const BodyParticles& body : bodies_) {
    std::vector<Stage>& stages = chain->stages.emplace_back();
    for (Pass pass : passes)
      for (Stage stage : stages_of(pass, body)) stages.push_back(stage);
  }
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
    transfer_.load_window(scratch.window, tiles_.nodes_around(tile), chain.mask);
  }
  const int window_nodes = transfer_.layout.window_nodes;
  double* sums = tiles_.sums(index) + chain.first_sum * window_nodes;
  std::fill(sums, sums + chain.sums * window_nodes, 0.0);
  for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) {
    Block block = make_block(tile, tiles_.blocks()[b], scratch);
    block.sums = tiles_.sums(index);
    for (Stage stage : chain.stages[tiles_.blocks()[b].body]) stage(block);
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
  for (int axis = 0; axis < axes_; ++axis) {
    block.window_first[axis] = transfer_.layout.side * static_cast<double>(tile.at[axis]) - 1;
    block.lowest[axis] = tile.cells.lowest[axis];
    block.highest[axis] = tile.cells.highest[axis];
  }
  block.scratch = &scratch;
  return block;
}

template <class Of>
void Executor::or_diverge(Of&& of) {
  try {
    of();
  } catch (const FormulaNotFinite& error) {
    diverge(error.what(), "give a formula that is finite throughout the run");
  }
}

void Executor::prepare(const StepTimes& times) {
  times_ = times;
  or_diverge([&] { loads_.prepare(bodies_, times.time); });
  finish();
  or_diverge([&] { conditions_.prepare({times.time, times.before, times.after, times.drift}); });
  sweep_.kick = times.kick();
  sweep_.drift = times.drift;
}

NodeBlock Executor::node_block(std::size_t tile, std::size_t thread) {
  NodeBlock block;
  block.nodes = tiles_.nodes(tile);
  block.sums = tiles_.sums_around(tiles_.tiles()[tile]);
  block.sum_quantities = tiles_.sum_quantities();
  block.kick = times_.kick();
  block.damping = model_.damping;
  block.least_mass = least_mass_share * lightest_particle_;
  block.collected = &collected_[conditions_.on_surfaces() ? tile : thread];
  return block;
}

void Executor::complete(NodeBlock& block, std::size_t tile, double light_node) {
  if (light_node > 0) {
    block.light_mass = light_node * lightest_particle_;
    motion_.calm_light_nodes(block);
    conditions_.act_on_mapped(tile);
  }
  if (!account_) return;
  motion_.account(block);
  tile_reactions_[tile] += {block.work, block.dissipated};
}

void Executor::update_velocities(const StepTimes& times, double light_node) {
  prepare(times);
  loads_.add_to(tiles_, bodies_);
  const bool in_one_pass = !conditions_.on_surfaces();
  for_each_tile([&](std::size_t tile, std::size_t thread) {
    NodeBlock block = node_block(tile, thread);
    transfer_.update_velocities(block);
    tile_reactions_[tile] = conditions_.act(tile);
    if (in_one_pass) complete(block, tile, light_node);
  });
  Reaction reaction;
  if (!in_one_pass) {
    reaction = conditions_.act_on_surfaces(bodies_, tiles_);
    for_each_tile([&](std::size_t tile, std::size_t thread) {
      NodeBlock block = node_block(tile, thread);
      complete(block, tile, light_node);
    });
    if (light_node > 0) conditions_.act_on_mapped_surfaces(bodies_, tiles_, false);
  }
  if (!account_) return;
  for (const Reaction& of_tile : tile_reactions_) reaction += of_tile;
  work_ += reaction.work;
  dissipated_ += reaction.dissipated;
}

void Executor::map_velocities(bool with_mass) {
  finish();
  for_each_tile([&](std::size_t tile, std::size_t thread) {
    NodeBlock block = node_block(tile, thread);
    block.collect_mass = with_mass;
    transfer_.map_velocities(block);
    conditions_.act_on_mapped(tile);
  });
  conditions_.act_on_mapped_surfaces(bodies_, tiles_, with_mass);
}

}  // namespace trajan
