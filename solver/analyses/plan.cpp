#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/analyses/rehearsal.h"
#include "solver/implicit/equations.h"
#include "solver/schemes/time_step.h"

namespace trajan {

namespace {

/// Of some of the particles, evenly chosen.
double largest_initial_speed(const Model& model) {
  constexpr std::int64_t most = 1000;
  double largest = 0;
  for (const Body& body : model.bodies) {
    const std::int64_t stride = body.particles / most + 1;
    for (std::int64_t number = 0; number < body.particles; number += stride) {
      const Vector at = body.lattice.point_of(number);
      double square = 0;
      for (const auto* component : {&body.velocity_x, &body.velocity_y, &body.velocity_z})
        if (*component) square += std::pow((**component)(at, 0), 2);
      if (std::isfinite(square)) largest = std::max(largest, std::sqrt(square));
    }
  }
  return largest;
}

void plan_explicit_steps(const Model& model, ModelPlan& plan) {
  const TimeStepLimit limit = time_step_limit(model);
  plan.time_step_limit = limit.because;
  const double speed = largest_initial_speed(model);
  double stable = limit.value;
  // What moves makes steps shorter, but not which wave is the fastest.
  for (const Material& material : model.materials)
    stable = std::min(
        stable,
        stable_time_step(model, material.kind->wave_speed(material.parameters, material.density, model.dimension),
                         speed));
  const double largest = model.numerics.time_step.value_or(model.numerics.time_step_fraction * stable);
  const double interval = model.end_time / static_cast<double>(model.outputs.samples);
  constexpr double most_steps = 1e15;
  const double in_interval = std::clamp(std::ceil(interval / largest - 1e-9), 1.0,
                                        most_steps / static_cast<double>(model.outputs.samples));
  plan.time_step = interval / in_interval;
  plan.steps = static_cast<std::int64_t>(in_interval) * model.outputs.samples;
}

/// Waves of all bodies are as slow as the slowest ones. How many steps a load level takes, nobody knows
/// beforehand, but a wave runs through the bodies at least once.
void plan_relaxation(const Model& model, ModelPlan& plan) {
  double longest = 0, slowest = std::numeric_limits<double>::infinity();
  std::string material_name;
  for (const Body& body : model.bodies) {
    const Lattice& lattice = body.lattice;
    longest = std::max({longest, static_cast<double>(lattice.columns) * lattice.spacing.x,
                        static_cast<double>(lattice.rows) * lattice.spacing.y,
                        static_cast<double>(lattice.planes) * lattice.spacing.z});
    const Material& material = model.materials[body.material];
    const double speed = material.kind->wave_speed(material.parameters, material.density, model.dimension);
    if (speed >= slowest) continue;
    slowest = speed;
    material_name = material.name;
  }
  plan.time_step =
      model.numerics.time_step.value_or(model.numerics.time_step_fraction * stable_time_step(model, slowest, 0));
  const double crossing = std::clamp(std::ceil(longest / (slowest * plan.time_step)), 1.0, 1e9);
  plan.steps = static_cast<std::int64_t>(crossing) * model.outputs.samples;
  plan.time_step_limit = "wave speed of material " + material_name +
                         "; steps: at least, a wave through the bodies for each load level";
}

/// A mode for each sample.
void plan_modes(const Model& model, ModelPlan& plan) {
  plan.steps = model.outputs.samples;
  plan.time_step = model.end_time / static_cast<double>(plan.steps);
  plan.time_step_limit = "modes: one for each sample";
}

/// Steps of the length that is asked for; each takes several iterations.
void plan_implicit_steps(const Model& model, std::int64_t asked, ModelPlan& plan) {
  const auto samples = static_cast<std::int64_t>(model.outputs.samples);
  const std::int64_t in_interval = (asked + samples - 1) / samples;
  plan.steps = in_interval * samples;
  plan.time_step = model.end_time / static_cast<double>(plan.steps);
  plan.time_step_limit = "analysis";
}

/// Entries of a column of a Cholesky factor by nested dissection (George 1973): in the plane they grow with the
/// logarithm of the nodes across the body, in space with their number, the functions' reach being as many times as
/// wide. The constant is that of beams and membranes of 10^3 to 10^4 unknowns.
double entries_of_factor(const double (&nodes)[3], int axes, double reach) {
  constexpr double of_node = 6;
  const double across = std::max(2.0, *std::min_element(nodes, nodes + axes));
  const double separator = axes == 3 ? across : std::log2(across);
  return of_node * axes * (reach - 1) * separator;
}

/// Of particles' stencils and tangents, of sparse matrices and of their factor, or of multigrid: matrices on
/// coarser grids have a seventh part of the tangent's entries, and there are some numbers of each node. With what
/// is left over from assembling, a cube's peak is as much again.
std::int64_t memory_of_matrices(const Model& model, const Body& body, double active_cells) {
  // With what assembling and ordering hold of them, and the initial stress' stiffness where loads of buckling are
  // sought.
  const bool multigrid = takes_multigrid(model);
  const double matrices = multigrid ? 2.2 : std::holds_alternative<Buckling>(model.analysis) ? 10 : 7;
  constexpr double bytes_per_entry = sizeof(double) + sizeof(int);
  const int axes = grid_axes(model.dimension);
  const double reach = nodes_in_reach(model);
  const double lengths[] = {static_cast<double>(body.lattice.columns) * body.lattice.spacing.x,
                            static_cast<double>(body.lattice.rows) * body.lattice.spacing.y,
                            static_cast<double>(body.lattice.planes) * body.lattice.spacing.z};
  double nodes = active_cells, nodes_along[3] = {};
  for (int axis = 0; axis < axes; ++axis) {
    nodes *= 1 + (reach - 1) * model.grid.cell / lengths[axis];
    nodes_along[axis] = lengths[axis] / model.grid.cell + reach - 1;
  }
  const double components = axes * axes, row = row_entries(model);
  const double of_node = 3 * sizeof(std::uint32_t) + sizeof(double) * (1.0 + axes);
  const double of_particle = std::pow(reach, axes) * of_node + sizeof(double) * components * (components + 2);
  constexpr double of_cycles = 200;
  const double factor = multigrid ? of_cycles : entries_of_factor(nodes_along, axes, reach) * sizeof(double);
  const double of_unknown = row * matrices * bytes_per_entry + factor;
  return static_cast<std::int64_t>(nodes * axes * of_unknown + static_cast<double>(body.particles) * of_particle);
}

}  // namespace

bool solves_for_displacements(const Model& model) {
  return !std::holds_alternative<ExplicitDynamics>(model.analysis) &&
         !std::holds_alternative<Relaxation>(model.analysis);
}

ModelPlan plan(const Model& model) {
  ModelPlan plan;
  plan.particles = model.particle_count();
  if (const auto* statics = std::get_if<QuasiStatic>(&model.analysis))
    plan_implicit_steps(model, statics->load_steps, plan);
  else if (const auto* dynamics = std::get_if<ImplicitDynamics>(&model.analysis))
    plan_implicit_steps(model, dynamics->time_steps, plan);
  else if (std::holds_alternative<Modal>(model.analysis) || std::holds_alternative<Buckling>(model.analysis))
    plan_modes(model, plan);
  else if (std::holds_alternative<Relaxation>(model.analysis))
    plan_relaxation(model, plan);
  else
    plan_explicit_steps(model, plan);

  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    const double spacing[] = {body.lattice.spacing.x, body.lattice.spacing.y, body.lattice.spacing.z};
    double per_cell = 1;
    for (int axis = 0; axis < grid_axes(model.dimension); ++axis) per_cell *= model.grid.cell / spacing[axis];
    const double active_cells = std::ceil(static_cast<double>(body.particles) / per_cell);
    plan.active_cells += static_cast<std::int64_t>(active_cells);
    if (solves_for_displacements(model)) plan.matrix_bytes += memory_of_matrices(model, body, active_cells);
  }
  rehearse(model, plan);
  plan.memory_bytes = plan.particle_bytes + plan.grid_bytes + plan.matrix_bytes;
  return plan;
}

}  // namespace trajan
