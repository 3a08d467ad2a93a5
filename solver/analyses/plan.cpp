#include <algorithm>
#include <cmath>

#include "solver/analyses/run.h"
#include "solver/schemes/time_step.h"
#include "solver/simulation/particles.h"
#include "solver/transfers/transfer.h"

namespace trajan {

namespace {

void plan_explicit_steps(const Model& model, ModelPlan& plan) {
  const TimeStepLimit limit = time_step_limit(model);
  plan.time_step_limit = limit.because;
  const double largest = model.numerics.time_step.value_or(model.numerics.time_step_fraction * limit.value);
  const double interval = model.end_time / static_cast<double>(model.outputs.samples);
  const double in_interval = std::max(1.0, std::ceil(interval / largest - 1e-9));
  plan.time_step = interval / in_interval;
  plan.steps = static_cast<std::int64_t>(in_interval) * model.outputs.samples;
}

/// Steps of the length that is asked for; each takes several iterations.
void plan_implicit_steps(const Model& model, std::int64_t asked, ModelPlan& plan) {
  const auto samples = static_cast<std::int64_t>(model.outputs.samples);
  const std::int64_t in_interval = (asked + samples - 1) / samples;
  plan.steps = in_interval * samples;
  plan.time_step = model.end_time / static_cast<double>(plan.steps);
  plan.time_step_limit = "analysis";
}

}  // namespace

ModelPlan plan(const Model& model) {
  ModelPlan plan;
  plan.particles = model.particle_count();
  if (const auto* statics = std::get_if<QuasiStatic>(&model.analysis))
    plan_implicit_steps(model, statics->load_steps, plan);
  else if (const auto* dynamics = std::get_if<ImplicitDynamics>(&model.analysis))
    plan_implicit_steps(model, dynamics->time_steps, plan);
  else if (std::holds_alternative<Modal>(model.analysis) || std::holds_alternative<Buckling>(model.analysis))
    plan_implicit_steps(model, model.outputs.samples, plan);
  else
    plan_explicit_steps(model, plan);

  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    const double spacing[] = {body.lattice.spacing.x, body.lattice.spacing.y, body.lattice.spacing.z};
    double per_cell = 1;
    for (int axis = 0; axis < grid_axes(model.dimension); ++axis) per_cell *= model.grid.cell / spacing[axis];
    plan.active_cells += static_cast<std::int64_t>(std::ceil(static_cast<double>(body.particles) / per_cell));
    std::int64_t bytes = sizeof(std::uint32_t);
    for (const AttributeNeed& need : attributes_needed(model, b)) {
      const std::string name(attribute_name(need.attribute));
      bytes += sizeof(double);
      bool known = false;
      for (const ModelPlan::Attribute& a : plan.attributes) known = known || a.name == name;
      if (!known) plan.attributes.push_back({name, sizeof(double), need.wanted_by});
    }
    plan.memory_bytes += bytes * body.particles;
  }
  plan.attributes.push_back({"number", sizeof(std::uint32_t), "outputs"});
  // Nodes and windows of the tiles in which the material is.
  const int axes = grid_axes(model.dimension);
  const Layout& layout = kernels().transfer(model.numerics.shape_functions, model.dimension)->layout;
  const int node_vectors_needed = find_transfer(model.numerics.transfer)->node_vectors;
  const std::int64_t tiles = plan.active_cells / tile_nodes + 1;
  plan.memory_bytes += tiles * static_cast<std::int64_t>((quantities(node_vectors_needed, axes) * tile_nodes +
                                                          quantities(sum_vectors, axes) * layout.window_nodes) *
                                                         sizeof(double));
  return plan;
}

}  // namespace trajan
