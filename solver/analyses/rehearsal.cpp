#include "solver/analyses/rehearsal.h"

#include <algorithm>
#include <cmath>

#include "solver/schemes/scheme.h"
#include "solver/schemes/schemes.h"
#include "solver/simulation/executor.h"

namespace trajan {
namespace {

/// So many particles are looked at to count the tiles that they lie in, in about a tenth of a second.
constexpr std::int64_t most_counted = 10'000'000;

/// The model with bodies that have no particles: to make an executor for it takes no time.
Model emptied(const Model& model) {
  Model empty = model;
  for (Body& body : empty.bodies) {
    body.particles = 0;
    body.lattice.geometry = Box{};
    body.lattice.columns = 0;
    body.lattice.rows = body.lattice.planes = 1;
  }
  return empty;
}

/// Adds who wants it to the attribute's row, which is a new one at first.
void want(std::vector<ModelPlan::Attribute>& rows, const std::string& name, std::size_t bytes,
          const std::string& wanted_by) {
  const auto row = std::ranges::find(rows, name, &ModelPlan::Attribute::name);
  if (row == rows.end())
    rows.push_back({name, static_cast<int>(bytes), wanted_by});
  else if (row->wanted_by.find(wanted_by) == std::string::npos)
    row->wanted_by += ", " + wanted_by;
}

void plan_particles(const Model& model, const Executor& executor, ModelPlan& plan) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyParticles& body = executor.bodies()[b];
    std::int64_t bytes = sizeof(std::uint32_t);
    const auto size = [&body](Attribute a) { return body.is_float(a) ? sizeof(float) : sizeof(double); };
    for (Attribute a : body.present) bytes += static_cast<std::int64_t>(size(a));
    for (const AttributeNeed& need : body.needs)
      want(plan.attributes, std::string(attribute_name(need.attribute)), size(need.attribute), need.wanted_by);
    plan.particle_bytes += bytes * model.bodies[b].particles;
  }
  want(plan.attributes, "number", sizeof(std::uint32_t), "outputs");
}

/// Quantities of a node, in the order in which tiles have them, and of the sums that particles scatter.
void plan_nodes(const Model& model, const Executor& executor, ModelPlan& plan) {
  constexpr const char* vectors[] = {"acceleration", "velocity", "mapped_velocity", "remainder",
                                     "projected_velocity"};
  constexpr const char* sums[] = {"sum.momentum", "sum.internal_force", "sum.load"};
  constexpr const char* axis_names[] = {".x", ".y", ".z"};
  const std::string scheme = "scheme " + model.numerics.scheme, transfer = "transfer " + model.numerics.transfer;
  const int axes = grid_axes(model.dimension);
  const auto add_vector = [&](const std::string& name, const std::string& wanted_by) {
    for (int axis = 0; axis < axes; ++axis)
      want(plan.node_attributes, name + axis_names[axis], sizeof(double), wanted_by);
  };
  want(plan.node_attributes, "mass", sizeof(double), scheme);
  for (int vector = 0; quantities(vector, axes) < executor.node_quantities(); ++vector)
    add_vector(vectors[vector], vector < node_vectors ? scheme : transfer);
  want(plan.node_attributes, "sum.mass", sizeof(double), scheme);
  for (int vector = 0; quantities(vector, axes) < executor.tiles().sum_quantities(); ++vector)
    add_vector(sums[vector], vector == sum_load ? "loads" : scheme);
}

struct PlannedTiles {
  std::size_t bytes;     ///< without what nodes hold
  bool fields_meet;      ///< of bodies in contact
  std::int64_t windows;  ///< for one thread
};

/// Of so many tiles where those of two rows, or layers, need one at a time.
std::int64_t windows_of_wave(double tiles, int axes) {
  return static_cast<std::int64_t>(2 * std::pow(tiles, 1 - 1.0 / axes)) + 3;
}

/// Tiles at time 0; of too many particles about as many as their cells fill.
PlannedTiles plan_tiles(const Model& model, const Executor& executor, ModelPlan& plan) {
  const Tiles& tiles = executor.tiles();
  if (plan.particles > most_counted) {
    plan.occupied_tiles = plan.tiles = plan.active_cells / tile_nodes + 1;
    const auto count = static_cast<double>(plan.tiles);
    return {static_cast<std::size_t>(plan.tiles) * sizeof(Tile), model.contacts.fields > 1,
            executor.by_wave() ? windows_of_wave(count, tiles.layout().dimensions) : plan.tiles};
  }
  const std::vector<OccupiedTile> occupied = occupied_tiles(model, tiles);
  // Tiles whose nodes hold nothing cost no memory here, however large the model is.
  Tiles bare(tiles.layout(), 0, 0, tiles.period());
  bare.rebuild(occupied, {}, std::vector<std::uint32_t>(occupied.size(), 0));
  plan.tiles = static_cast<std::int64_t>(bare.tiles().size());
  plan.occupied_tiles = static_cast<std::int64_t>(occupied.size());
  const bool meet = std::ranges::adjacent_find(bare.tiles(), {}, &Tile::at) != bare.tiles().end();
  if (!executor.by_wave()) return {bare.memory(), meet, plan.occupied_tiles};
  ThreadPool alone(1);
  TileLoop loop(alone);
  loop.bind(bare);
  return {bare.memory(), meet, loop.plan_waves(bare).count};
}

void plan_grid(const Model& model, const Executor& executor, ModelPlan& plan) {
  const Tiles& tiles = executor.tiles();
  const PlannedTiles planned = plan_tiles(model, executor, plan);
  const std::int64_t nodes = executor.node_quantities() * tile_nodes;
  const std::int64_t window = tiles.sum_quantities() * tiles.layout().window_nodes;
  const std::int64_t collected = executor.in_one_pass() && !planned.fields_meet ? 1 : plan.tiles;
  const std::int64_t doubles = plan.tiles * nodes + planned.windows * window + std::max(nodes, window);
  plan.grid_bytes = static_cast<std::int64_t>(executor.memory() + planned.bytes + sizeof(double) * doubles +
                                              sizeof(NodeSums) * collected);
}

ModelPlan::Sweep described(const Sweep& sweep, const Executor& executor, const Model& model) {
  ModelPlan::Sweep row;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    std::vector<std::string> stages;
    for (Stage stage : sweep.stages[b]) stages.push_back(executor.sweeps().name(stage, executor.bodies()[b], b));
    const auto same = std::ranges::find(row.of_bodies, stages, &ModelPlan::BodyStages::stages);
    if (same == row.of_bodies.end())
      row.of_bodies.push_back({{model.bodies[b].name}, stages});
    else
      same->bodies.push_back(model.bodies[b].name);
  }
  return row;
}

/// Those of a step that follows another one: the first one of an interval between samples begins differently.
void plan_sweeps(const Model& model, Executor& executor, ModelPlan& plan) {
  const Scheme& scheme = *find_scheme(model.numerics.scheme);
  StepTimes times;
  times.after = times.drift = plan.time_step;
  scheme.step(executor, times);
  std::vector<std::int64_t> before;
  for (const auto& sweep : executor.sweeps().all()) before.push_back(sweep->runs);
  scheme.step(executor, times);
  for (std::size_t i = 0; i < executor.sweeps().all().size(); ++i) {
    const Sweep& sweep = *executor.sweeps().all()[i];
    const std::int64_t runs = sweep.runs - (i < before.size() ? before[i] : 0);
    for (std::int64_t run = 0; run < runs; ++run) plan.sweeps.push_back(described(sweep, executor, model));
  }
}

}  // namespace

void rehearse(const Model& model, ModelPlan& plan) {
  const Model empty = emptied(model);
  Executor executor(empty, 1, Executor::Filling::nothing);
  // What a run may need: it begins with less.
  if (!is_total_lagrangian(model.numerics.scheme)) executor.expect_drift();
  plan_particles(model, executor, plan);
  plan_nodes(model, executor, plan);
  plan_grid(model, executor, plan);
  if (std::holds_alternative<ExplicitDynamics>(model.analysis) ||
      std::holds_alternative<Relaxation>(model.analysis))
    plan_sweeps(model, executor, plan);
}

}  // namespace trajan
