#include "solver/cost/run_time.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "solver/implicit/equations.h"
#include "solver/results/chunks.h"
#include "solver/schemes/scheme.h"
#include "solver/transfers/transfer.h"

namespace trajan {
namespace {

/// What a tile without particles takes, of one with some.
constexpr double reached_share = 0.4;

/// Of a second-level cache, about.
constexpr double cached_bytes = 1 << 20;

/// Iterations of Newton's method per load step or time step, of laws that are not linear: about what the scenes of
/// the gallery take.
constexpr double iterations_per_step = 5;
/// Steps of a relaxation per crossing of a wave through the longest body, likewise.
constexpr double crossings_per_level = 20;

/// Of assembling a matrix, what it takes to solve with it by multigrid: both grow with the cells.
constexpr double cycles_share = 0.6;

class RateTable {
 public:
  explicit RateTable(const Rates& rates) : rates_(rates) {}
  double operator[](const std::string& name) {
    const auto found = rates_.find(name);
    if (found != rates_.end()) return found->second;
    complete_ = false;
    return 0;
  }
  bool complete() const { return complete_; }

 private:
  const Rates& rates_;
  bool complete_ = true;
};

/// Laws and transfers are measured as differences, which noise may make too small; none makes a step five times as
/// fast.
double with_difference(double plain, double difference) { return std::max(plain + difference, plain / 5); }

double formulas(const Model& model) {
  double sum = 0;
  for (const BodyLoad& load : model.body_loads)
    for (const std::optional<Expression>& component : load.field)
      for (const std::size_t body : load.bodies)
        if (component)
          sum += static_cast<double>(component->text().size()) * static_cast<double>(model.bodies[body].particles);
  return sum;
}

bool is_linear(const Model& model) {
  return std::ranges::all_of(model.bodies, [&](const Body& body) {
    return model.materials[body.material].kind->name == "linear_strain_elastic";
  });
}

double explicit_step_seconds(const Model& model, const StepSize& size, RateTable& rates) {
  const auto of = [&](const char* part) { return rates[step_rate(model.dimension, model.numerics, part)]; };
  const double plain = of("step") + of("tile") * size.tiles + of("particle") * size.particles;
  double difference = 0;
  if (model.numerics.transfer != Numerics{}.transfer) {
    Numerics numerics = model.numerics;
    constexpr int measured_orders = 3;
    const bool ordered = find_transfer(numerics.transfer)->ordered;
    const int order = ordered ? numerics.transfer_order.value_or(default_transfer_order) : 0;
    if (ordered)
      numerics.transfer_order = std::min(order, measured_orders);
    else
      numerics.transfer_order.reset();
    const double most = rates[transfer_rate(model.dimension, numerics)];
    double more = most;
    if (order > measured_orders) {
      numerics.transfer_order = measured_orders - 1;
      more += (order - measured_orders) * (most - rates[transfer_rate(model.dimension, numerics)]);
    }
    difference += more * size.particles;
  }
  const bool total = is_total_lagrangian(model.numerics.scheme);
  for (const Body& body : model.bodies)
    difference += rates[law_rate(model.dimension, total, model.materials[body.material].kind->name)] *
                  static_cast<double>(body.particles);
  double seconds = with_difference(plain, difference);
  if (model.contacts.fields > 1)
    seconds += rates[contact_rate(model.dimension, model.numerics.shape_functions)] * size.layer *
               (model.contacts.fields - 1);
  seconds += rates[formula_rate()] * size.formulas + rates[memory_rate()] * size.uncached_bytes;
  return seconds;
}

double iteration(const Model& model, const StepSize& size, RateTable& rates) {
  const auto of = [&](const char* part) {
    return rates[iteration_rate(model.dimension, model.numerics.shape_functions, part)];
  };
  double difference = 0;
  for (const Body& body : model.bodies)
    difference += rates[tangent_rate(model.dimension, model.materials[body.material].kind->name)] *
                  static_cast<double>(body.particles);
  const double assembly = of("assembly") * size.particles, factors = of("factors") * size.factor_work;
  return with_difference(assembly + (size.multigrid ? cycles_share * assembly : factors), difference);
}

/// Steps and what they take together.
struct Steps {
  double count = 0, seconds = 0;
};

Steps steps_of(const Model& model, const ModelPlan& plan, RateTable& rates) {
  const StepSize size = step_size(model, plan);
  const auto planned = static_cast<double>(plan.steps);
  if (std::holds_alternative<ExplicitDynamics>(model.analysis))
    return {planned, planned * explicit_step_seconds(model, size, rates)};
  if (std::holds_alternative<Relaxation>(model.analysis)) {
    const double steps = planned * crossings_per_level;
    return {steps, steps * explicit_step_seconds(model, size, rates)};
  }
  const double each = iteration(model, size, rates);
  if (std::holds_alternative<Modal>(model.analysis) || std::holds_alternative<Buckling>(model.analysis))
    return {planned, each * rates[modes_rate()]};
  const double iterations = planned * (is_linear(model) ? 1 : iterations_per_step);
  return {iterations, iterations * each};
}

/// Components of the fields of a snapshot, positions and velocities among them, as the file has them: those of a
/// solid.
std::vector<std::size_t> stored_components(const Model& model) {
  std::vector<std::size_t> components(2, vector_components(Dimension::solid).size());
  for (const RecordedField& field : model.outputs.snapshot_fields)
    components.push_back(std::max<std::size_t>(1, field_components(field.field, Dimension::solid).size()));
  return components;
}

/// Of a snapshot in memory.
double copied_snapshot_bytes(const Model& model) {
  std::size_t components = 2 * vector_components(model.dimension).size();
  for (const RecordedField& field : model.outputs.snapshot_fields)
    components += std::max<std::size_t>(1, field.components.size());
  return static_cast<double>(sizeof(double) * components) * static_cast<double>(model.particle_count());
}

/// HDF5 keeps what fits into a mebibyte of the chunks of each dataset.
double cached_chunk_bytes(const Model& model) {
  constexpr double most = 1 << 20;
  if (model.outputs.samples_per_snapshot == 0) return 0;
  const auto snapshots = static_cast<double>(model.outputs.samples / model.outputs.samples_per_snapshot + 1);
  const auto particles = static_cast<double>(model.particle_count());
  const double rows = std::min(particles, static_cast<double>(results::rows_per_chunk));
  double sum = 0;
  for (const std::size_t components : stored_components(model)) {
    const double chunk = static_cast<double>(sizeof(double) * components) * rows;
    sum += chunk * std::min(std::floor(most / chunk), std::ceil(snapshots * particles / rows));
  }
  return sum;
}

}  // namespace

StepSize step_size(const Model& model, const ModelPlan& plan) {
  StepSize size;
  size.particles = static_cast<double>(model.particle_count());
  size.tiles = static_cast<double>(plan.occupied_tiles) +
               reached_share * static_cast<double>(plan.tiles - plan.occupied_tiles);
  size.factor_work = factor_work(model);
  size.multigrid = takes_multigrid(model);
  const int axes = grid_axes(model.dimension);
  size.layer = std::pow(size.particles, (axes - 1.0) / axes);
  size.formulas = formulas(model);
  size.uncached_bytes = std::max(0.0, static_cast<double>(plan.particle_bytes) - cached_bytes);
  return size;
}

/// The largest of what is held while the solver runs and while the file is finished: then the solver's arrays are
/// gone.
std::optional<double> run_memory(const Model& model, const ModelPlan& plan, const Rates& bytes) {
  RateTable table(bytes);
  // What a worker takes to speak with its server; rates are measured without one.
  constexpr double spoken = 600 << 10;
  // Rates are of rows without probes.
  const double columns_of_rate = 8, columns = static_cast<double>(history_columns(model).size());
  const double rows = table[recording_rate("row")] * static_cast<double>(model.outputs.samples) * (columns + 1) /
                      (columns_of_rate + 1);
  const double running = table[recording_rate("running")] + array_bytes(model, plan);
  const double finishing = table[recording_rate("run")] + cached_chunk_bytes(model);
  return table.complete() ? std::optional(spoken + rows + std::max(running, finishing)) : std::nullopt;
}

/// One snapshot is being made, and a copy of one is being written meanwhile.
double array_bytes(const Model& model, const ModelPlan& plan) {
  constexpr double copies = 2;
  const double snapshots = model.outputs.samples_per_snapshot == 0 ? 0 : copies * copied_snapshot_bytes(model);
  return static_cast<double>(plan.memory_bytes) + snapshots + cached_chunk_bytes(model);
}

double snapshot_bytes(const Model& model) {
  const std::vector<std::size_t> components = stored_components(model);
  return static_cast<double>(sizeof(double) *
                             std::accumulate(components.begin(), components.end(), std::size_t{0})) *
         static_cast<double>(model.particle_count());
}

std::optional<double> iteration_seconds(const Model& model, const StepSize& size, const Rates& rates) {
  RateTable table(rates);
  const double seconds = iteration(model, size, table);
  return table.complete() ? std::optional(seconds) : std::nullopt;
}

std::optional<RunTime> run_time(const Model& model, const ModelPlan& plan, int threads, const Rates& rates) {
  RateTable table(rates);
  const Steps steps = steps_of(model, plan, table);
  const auto samples = static_cast<double>(model.outputs.samples);
  const auto particles = static_cast<double>(model.particle_count());
  double sampling = 0;
  for (const Body& body : model.bodies)
    sampling += samples * static_cast<double>(body.particles) *
                table[sample_rate(model.dimension, is_total_lagrangian(model.numerics.scheme),
                                  model.materials[body.material].kind->name)];
  const double snapshots = model.outputs.samples_per_snapshot == 0
                               ? 0
                               : samples / static_cast<double>(model.outputs.samples_per_snapshot) + 1;
  const auto recording = [&](std::string (*rate)(std::string_view)) {
    return table[rate("run")] + table[rate("particle")] * particles + table[rate("row")] * samples +
           snapshots * (table[rate("snapshot")] + table[rate("snapshot_byte")] * snapshot_bytes(model));
  };
  const double waiting = threads > 1 ? steps.count * table[waiting_rate()] : 0;
  RunTime time;
  time.steps = steps.count;
  time.core_seconds = steps.seconds + sampling + recording(processing_rate);
  time.wall_seconds = (steps.seconds + sampling) / threads + waiting + recording(recording_rate);
  if (!table.complete()) return std::nullopt;
  return time;
}

}  // namespace trajan
