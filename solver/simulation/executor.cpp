#include "solver/simulation/executor.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "solver/contact/surface_gaps.h"
#include "solver/simulation/diverged.h"
#include "solver/simulation/grid_choice.h"
#include "solver/simulation/kinks.h"
#include "solver/simulation/make_scratch.h"

namespace trajan {
namespace {

/// Nodes with less than this share of the lightest particle's mass carry nothing but rounding.
constexpr double least_mass_share = 1e-18;

/// What gravity does to all nodes alike it does to those that have been calmed too: their velocities for gradients
/// take part in the kick by loads, as far as these accelerate whole bodies. A load on a surface is as large on
/// light nodes as on others.
void add_gravity_to_calmed(const NodeBlock& block, const std::vector<BodyParticles>& bodies, const Model& model,
                           int axes) {
  const double* mass = block.nodes + tile_array(quantity_mass);
  for (int axis = 0; axis < axes; ++axis) {
    double most = model.surface_loads.empty() ? HUGE_VAL : 0;
    for (const BodyParticles& body : bodies) most = std::max(most, std::abs(body.constants.acceleration[axis]));
    const double* load = block.collected->values[quantity(sum_load, axis, axes)];
    double* w = block.nodes + tile_array(quantity(node_mapped_velocity, axis, axes));
    for (int i = 0; i < tile_nodes; ++i)
      if (mass[i] > block.least_mass && mass[i] < block.light_mass)
        w[i] += block.kick * std::clamp(load[i] / mass[i], -most, most);
  }
}

/// What is collected next may be a tile's whose nodes get none.
void forget_loads(NodeSums& sums, int axes) {
  for (int axis = 0; axis < axes; ++axis) std::ranges::fill(sums.values[quantity(sum_load, axis, axes)], 0.0);
}

/// In another tile.
void place(Block& block, const Tile& tile, const Layout& layout) {
  for (int axis = 0; axis < layout.dimensions; ++axis) {
    block.window_first[axis] = layout.side * static_cast<double>(tile.at[axis]) - 1;
    block.lowest[axis] = tile.cells.lowest[axis];
    block.highest[axis] = tile.cells.highest[axis];
  }
}

/// To other particles of the same body.
void point_to(Block& block, const BodyParticles& body, const BlockRange& range) {
  block.count = range.count;
  for (Attribute a : body.present) {
    const auto k = static_cast<std::size_t>(a);
    if (body.floats[k].empty())
      block.arrays[k] = const_cast<double*>(body.arrays[k].data()) + range.begin;
    else
      block.floats[k] = const_cast<float*>(body.floats[k].data()) + range.begin;
  }
}

}  // namespace

Executor::Executor(const Model& model, int threads, Filling filling)
    : model_(model),
      rehearsal_(filling == Filling::nothing),
      axes_(grid_axes(model.dimension)),
      motion_(kernels().grid(model.numerics).motion[axes_ - 1]),
      transfer_kind_(*find_transfer(model.numerics.transfer)),
      pool_(threads),
      loop_(pool_),
      bodies_(make_bodies(model)),
      conditions_(model),
      contacts_(model, threads),
      loads_(model),
      transfer_(&transfer_kernels(model, first_margin(model, conditions_, loads_))),
      tiles_(make_tiles(model, *transfer_)),
      sweeps_(model, transfer_kind_, *transfer_,
              loads_.are_everywhere() ? tiles_.sum_quantities() : quantities(sum_load, axes_)),
      account_(model) {
  if (!rehearsal_) add_particles(model, bodies_);
  sweep_.cell = model.grid.cell;
  sweep_.inverse_cell = 1 / model.grid.cell;
  const double origin[] = {model.grid.origin.x, model.grid.origin.y, model.grid.origin.z};
  for (int axis = 0; axis < axes_; ++axis) {
    sweep_.origin[axis] = sweep_.lower[axis] = origin[axis];
    sweep_.faces[axis] = static_cast<double>(model.grid.cells()[axis]);
    sweep_.upper[axis] = origin[axis] + model.grid.cell * sweep_.faces[axis];
    if (!model.grid.periodic[axis]) continue;
    sweep_.period[axis] = sweep_.faces[axis];
    sweep_.lower[axis] = -HUGE_VAL;
    sweep_.upper[axis] = HUGE_VAL;
  }
  sweep_.flip = model.numerics.flip_fraction.value_or(1);
  lightest_particle_ = lightest_particle(bodies_);
  if (SurfaceGaps::are_needed(model)) {
    gaps_ = std::make_unique<SurfaceGaps>(model, tiles_, bodies_, sweep_);
    conditions_.measure_gaps_by(*gaps_);
  }
  by_wave_ = get_from_particles_alone(model, conditions_, loads_) && !gaps_;
  accounts_ = !loads_.none() || model.damping > 0 || conditions_.work() || model.contacts.fields > 1 ||
              !model.outputs.reactions.empty();
  for (int thread = 0; thread < threads; ++thread) scratch_.push_back(make_scratch(model, *transfer_, bodies_));
}

Executor::~Executor() = default;

void Executor::expect_drift() {
  if (transfer_->layout.margin == Margin::one_cell) return;
  transfer_ = &transfer_kernels(model_, Margin::one_cell);
  tiles_ = make_tiles(model_, *transfer_);
  sweeps_.use(*transfer_, bodies_);
  for (auto& scratch : scratch_) scratch = make_scratch(model_, *transfer_, bodies_);
}

void Executor::sort() {
  sort_into_tiles(model_.grid, cell_order(model_, *transfer_), bodies_, tiles_, pool_);
  ++sortings_;
  order_ = {};
  bind();
}

void Executor::begin() {
  sort();
  if (sweeps_.transfer_passes().begin.stages.empty()) return;
  particles({Pass::locate, Pass::begin});
  finish();
}

void Executor::bind() {
  or_diverge([&] { conditions_.bind(bodies_, tiles_); });
  loads_.bind(bodies_, tiles_);
  contacts_.bind(tiles_);
  // What acts between two passes over the tiles needs what the first found in the second.
  const std::size_t tiles = tiles_.tiles().size();
  collected_.resize(in_one_pass() ? scratch_.size() : tiles);
  loop_.bind(tiles_);
  if (by_wave_)
    tiles_.make_windows(loop_.plan_waves(tiles_));
  else
    tiles_.make_windows();
  blocks_.assign(scratch_.size(), {});
  account_.bind(tiles);
  unborne_forces_ = false;
}

void Executor::particles(std::initializer_list<Pass> passes) {
  for (Pass pass : passes) {
    // Loads that depend on place must know where particles are before the chain that scatters them begins.
    if (pass == Pass::locate && loads_.follow_particles()) finish();
    if ((pass == Pass::move || pass == Pass::displace) && !rehearsal_) {
      loads_.advect(tiles_, bodies_, times_.drift);
      conditions_.advect(tiles_, bodies_, times_.drift);
    }
    noted_.push_back(pass);
  }
}

void Executor::finish() { finish({}); }

void Executor::finish(const NodeWork& work) {
  if (noted_.empty()) {
    if (work) loop_.for_each(work);
    return;
  }
  // Whatever happens, these are done with: the sweep has its own copy of them.
  const std::span<const Pass> passes = sweeps_.of(noted_, bodies_).passes;
  noted_.clear();
  run(passes, work);
}

void Executor::run(std::span<const Pass> passes, const NodeWork& work) {
  const auto last = std::find(passes.rbegin(), passes.rend(), Pass::locate);
  const auto before_last = static_cast<std::size_t>(std::max<std::ptrdiff_t>(passes.rend() - last - 1, 0));
  if (before_last > 0 && order_.is_worn()) {
    // Nothing that comes after particles are located anew gathers from the grid as it is.
    run(passes.first(before_last));
    sort();
    run(passes.subspan(before_last), work);
    return;
  }
  Sweep& sweep = sweeps_.of(passes, bodies_);
  ++sweep.runs;
  const Trouble trouble = sweep_tiles(sweep, work);
  check(trouble);
  if (!trouble.left_window) {
    if (trouble.runs > 0) order_.count(trouble.runs);
    return;
  }
  // What has been scattered from clamped places is worthless, and so is what nodes have made of it; the particles
  // themselves are right.
  expect_drift();
  sort();
  run(passes.subspan(before_last), work);
}

Trouble Executor::sweep_tiles(const Sweep& sweep, const NodeWork& work) {
  for (auto& scratch : scratch_) scratch->trouble = {};
  const auto of_particles = [&](std::size_t tile, std::size_t thread) { run_tile(tile, sweep, thread); };
  if (work)
    loop_.by_wave(of_particles, work);
  else
    loop_.for_each(of_particles);
  Trouble trouble;
  for (const auto& scratch : scratch_) {
    trouble.runs += scratch->trouble.runs;
    trouble.left_window |= scratch->trouble.left_window;
    trouble.left_domain += scratch->trouble.left_domain;
    trouble.moved_too_far += scratch->trouble.moved_too_far;
    trouble.inverted += scratch->trouble.inverted;
    trouble.unsolved += scratch->trouble.unsolved;
  }
  return trouble;
}

void Executor::run_tile(std::size_t index, const Sweep& sweep, std::size_t thread) {
  const Tile& tile = tiles_.tiles()[index];
  if (tile.window < 0) return;
  if (sweep.mask) transfer_->load_window(*scratch_[thread], tiles_.nodes_around(tile), sweep.mask);
  const Layout& layout = transfer_->layout;
  double* sums = tiles_.sums(index);
  std::fill_n(sums + layout.window_array(sweep.first_sum), layout.window_array(sweep.sums), 0.0);
  Block& block = blocks_[thread];
  place(block, tile, transfer_->layout);
  for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) {
    const BlockRange& range = tiles_.blocks()[b];
    if (block.body == &bodies_[range.body].constants)
      point_to(block, bodies_[range.body], range);
    else
      block = make_block(tile, range, *scratch_[thread]);
    block.sums = sums;
    for (Stage stage : sweep.stages[range.body]) stage(block);
  }
}

Block Executor::make_block(const Tile& tile, const BlockRange& range, Scratch& scratch) const {
  const BodyParticles& body = bodies_[range.body];
  Block block;
  point_to(block, body, range);
  block.body = &body.constants;
  block.sweep = &sweep_;
  block.scratch = &scratch;
  place(block, tile, transfer_->layout);
  return block;
}

/// Turns a formula that fails into divergence.
template <class Of>
void Executor::or_diverge(Of&& of) {
  try {
    of();
  } catch (const FormulaNotFinite& error) {
    diverge(error.what(), "give a formula that is finite throughout the run");
  }
}

NodeBlock Executor::node_block(std::size_t tile, std::size_t thread) {
  // Made in place: what is copied as soon as it is written waits until all that was written before is in the
  // cache, as velocities of the last tile. By a profile 0.9 ns per particle and step in a plane.
  NodeBlock block{.nodes = tiles_.nodes(tile),
                  .sums = tiles_.sums_around(tiles_.tiles()[tile]),
                  .sum_quantities = tiles_.sum_quantities(),
                  .kick = times_.kick()};
  block.damping = model_.damping;
  block.least_mass = least_mass_share * lightest_particle_;
  block.collected = &collected_[in_one_pass() ? thread : tile];
  return block;
}

void Executor::complete(NodeBlock& block, std::size_t tile, double light_node) {
  if (light_node > 0) {
    block.light_mass = light_node * lightest_particle_;
    motion_.calm_light_nodes(block);
    if (!model_.body_loads.empty()) add_gravity_to_calmed(block, bodies_, model_, axes_);
    conditions_.act_on_mapped(tile);
  }
  if (account_.watched()) account_.balance_of_tile(tile) = force_balance(block, axes_);
  if (looks_for_unborne_forces_ && has_unborne_forces(block, axes_)) unborne_forces_ = true;
  if (!accounts_) return;
  if (model_.damping > 0 || loads_.reach(tile)) motion_.account(block);
  if (loads_.reach(tile) && !loads_.are_everywhere()) forget_loads(*block.collected, axes_);
  account_.of_tile(tile).back() = {block.work, block.dissipated, {}};
}

void Executor::update_velocities(const StepTimes& times, double light_node) {
  times_ = times;
  or_diverge([&] { loads_.prepare(bodies_, times.time); });
  or_diverge([&] { conditions_.prepare({times.time, times.before, times.after, times.drift}); });
  // Forces spread from where loads act; to look now and then finds them before half of the run is over.
  looks_for_unborne_forces_ =
      std::has_single_bit(static_cast<std::uint64_t>(times.step)) && has_kinks_at_rest(model_);
  if (by_wave_ && !rehearsal_)
    finish([&](std::size_t tile, std::size_t thread) { kick_tile(tile, thread, light_node); });
  else
    finish();
  // Not before: what has been noted goes on to the end of the step before. Contact asks how far this one goes.
  sweep_.kick = times.kick();
  sweep_.step = times.step;
  sweep_.drift = times.drift;
  if (!by_wave_ && !rehearsal_) kick_nodes(light_node);
  if (unborne_forces_)
    diverge(
        "particles at a body's surface lie exactly on faces of cells: nodes beyond them have a share of their "
        "forces but no mass, and would hold them fast",
        "take another domain.cell_size, or move domain.lower by a part of a cell, so that no particle of the "
        "surface lies on a face");
  const TransferPasses& transfer = sweeps_.transfer_passes();
  project(times.drift > 0 ? transfer.projection : transfer.projection_at_sample, light_node * lightest_particle_);
  if (accounts_ || account_.watched()) account_.add_up();
}

void Executor::kick_tile(std::size_t tile, std::size_t thread, double light_node) {
  NodeBlock block = node_block(tile, thread);
  if (!loads_.reach(tile)) block.sum_quantities = quantities(sum_load, axes_);
  transfer_->update_velocities(block);
  account_.forget_tile(tile);
  conditions_.act(tile, account_.of_tile(tile));
  if (in_one_pass()) complete(block, tile, light_node);
}

void Executor::kick_nodes(double light_node) {
  loads_.add_to(tiles_, bodies_);
  fold_images();
  loop_.for_each([&](std::size_t tile, std::size_t thread) { kick_tile(tile, thread, light_node); });
  if (!in_one_pass()) act_between_tiles(light_node);
  copy_to_images();
}

/// What needs all tiles' velocities.
void Executor::act_between_tiles(double light_node) {
  contacts_.find(pool_, tiles_, bodies_, sweep_, least_mass_share * lightest_particle_);
  account_.add_contact(contacts_.act(pool_, tiles_, conditions_.held(), times_.kick()));
  for (std::size_t i = 0; i < model_.outputs.contact_forces.size(); ++i)
    account_.add_contact(i, contacts_.impulse_on(model_.outputs.contact_forces[i], tiles_));
  conditions_.act_on_surfaces(bodies_, tiles_, account_.of_tile(0));
  loop_.for_each([&](std::size_t tile, std::size_t thread) {
    NodeBlock block = node_block(tile, thread);
    complete(block, tile, light_node);
  });
  if (light_node <= 0) return;
  contacts_.act_on(pool_, tiles_, conditions_.held(), node_mapped_velocity);
  conditions_.act_on_mapped_surfaces(bodies_, tiles_, false);
}

void Executor::map_velocities(bool with_mass) {
  const auto map_tile = [&](std::size_t tile, std::size_t thread) {
    NodeBlock block = node_block(tile, thread);
    block.collect_mass = with_mass;
    transfer_->map_velocities(block);
    conditions_.act_on_mapped(tile);
  };
  if (by_wave_ && !rehearsal_) return finish(map_tile);
  finish();
  if (rehearsal_) return;
  fold_images();
  loop_.for_each(map_tile);
  if (with_mass) contacts_.find(pool_, tiles_, bodies_, sweep_, least_mass_share * lightest_particle_);
  contacts_.act_on(pool_, tiles_, conditions_.held(), node_mapped_velocity);
  conditions_.act_on_mapped_surfaces(bodies_, tiles_, with_mass);
  copy_to_images();
}

void Executor::fold_images() {
  if (tiles_.period().any()) loop_.for_each([&](std::size_t tile, std::size_t) { tiles_.fold_images(tile); });
}

void Executor::copy_to_images() {
  if (tiles_.period().any()) loop_.for_each([&](std::size_t tile, std::size_t) { tiles_.copy_to_images(tile); });
}

}  // namespace trajan
