#include "server/estimate.h"

#include <algorithm>
#include <cmath>

#include "server/audit.h"
#include "server/estimate_errors.h"
#include "server/scene_digest.h"
#include "solver/analyses/run.h"
#include "solver/cost/run_time.h"

namespace trajan {

namespace {

/// Factors by which figures may be off either way, in nine of ten cases, as long as no finished jobs say so.
constexpr double model_factor = 2.5;        ///< held for 17 of 18 scenes of the gallery
constexpr double unknown_steps_factor = 3;  ///< of analyses whose steps nobody knows beforehand
constexpr double history_factor = 1.2;
constexpr double trial_factor = 1.25;
constexpr double memory_factor = 1.15;
constexpr double file_factor = 1.1;

v1::Figure figure(double value, double factor, v1::Figure::Source source, const std::string& basis) {
  v1::Figure made;
  made.set_value(value);
  made.set_low(value / factor);
  made.set_high(value * factor);
  made.set_source(source);
  made.set_basis(basis);
  return made;
}

bool knows_its_steps(const Model& model) {
  return std::holds_alternative<ExplicitDynamics>(model.analysis) ||
         std::holds_alternative<Modal>(model.analysis) || std::holds_alternative<Buckling>(model.analysis);
}

/// The factor that finished jobs of the source tell, otherwise the given one.
double factor_of(const Evidence& evidence, v1::Figure::Source source, double otherwise) {
  return usual_factor(evidence.recent, source).value_or(otherwise);
}

void estimate_by_model(const Model& model, const ModelPlan& plan, const Evidence& evidence,
                       v1::Estimate& estimate) {
  constexpr auto source = v1::Figure::MODEL;
  const double steps_factor = knows_its_steps(model) ? 1.1 : unknown_steps_factor;
  *estimate.mutable_steps() = figure(static_cast<double>(plan.steps), steps_factor, source, plan.time_step_limit);
  *estimate.mutable_result_bytes() =
      figure(static_cast<double>(result_bytes(model)), file_factor, source, "counted arrays");
  estimate.set_model_steps(static_cast<double>(plan.steps));
  if (!evidence.calibration) {
    estimate.set_missing("core_seconds, wall_seconds and memory_bytes: this machine has not been measured yet");
    return;
  }
  const auto& seconds = evidence.calibration->seconds();
  const auto time = run_time(model, plan, estimate.threads(), Rates(seconds.begin(), seconds.end()));
  const auto& bytes = evidence.calibration->bytes();
  const auto memory = run_memory(model, plan, Rates(bytes.begin(), bytes.end()));
  const std::string basis = "counted work and this machine's rates";
  if (memory) *estimate.mutable_memory_bytes() = figure(*memory, memory_factor, source, basis);
  if (!time) {
    estimate.set_missing("core_seconds, wall_seconds: there is no rate for what the scene combines");
    return;
  }
  const double factor =
      std::max(factor_of(evidence, source, model_factor), knows_its_steps(model) ? 1.0 : unknown_steps_factor);
  *estimate.mutable_steps() = figure(time->steps, steps_factor, source, plan.time_step_limit);
  estimate.set_model_steps(time->steps);
  *estimate.mutable_core_seconds() = figure(time->core_seconds, factor, source, basis);
  *estimate.mutable_wall_seconds() = figure(time->wall_seconds, factor, source, basis);
  estimate.set_model_wall_seconds(time->wall_seconds);
}

std::string method_of(const v1::Settings& settings) {
  return settings.numerics().scheme() + '/' + settings.numerics().shape_functions() + '/' +
         settings.numerics().transfer() + '/' + std::to_string(settings.analysis().kind_case());
}

/// How far settings of the same method are apart, in doublings; nothing if the methods differ.
std::optional<double> distance(const v1::Settings& a, const v1::Settings& b) {
  if (method_of(a) != method_of(b)) return std::nullopt;
  return std::abs(std::log2(a.cell_size() / b.cell_size())) +
         std::abs(std::log2(static_cast<double>(a.particles_per_cell_side()) / b.particles_per_cell_side()));
}

/// The nearest finished run of the family that says something about this one.
const v1::Prediction* nearest(const v1::Settings& settings, const v1::Estimate& estimate, const Evidence& evidence,
                              double& far) {
  const v1::Prediction* best = nullptr;
  for (const v1::Prediction& run : evidence.family) {
    const auto apart = distance(settings, run.settings());
    const bool comparable = estimate.has_model_wall_seconds() && run.estimate().model_wall_seconds() > 0;
    if (!apart || (*apart > 0 && !comparable) || run.cost().machine() != evidence.machine ||
        run.solver_version() != TRAJAN_VERSION || run.cost().threads() != estimate.threads())
      continue;
    if (best != nullptr && *apart >= far) continue;
    best = &run;
    far = *apart;
  }
  return best;
}

/// What the nearest run took, in proportion to what the model says of both.
void estimate_by_history(const v1::Settings& settings, const Evidence& evidence, v1::Estimate& estimate) {
  constexpr auto source = v1::Figure::HISTORY;
  double far = 0;
  const v1::Prediction* run = nearest(settings, estimate, evidence, far);
  if (run == nullptr) return;
  const v1::Estimate& before = run->estimate();
  const bool same = far == 0 && settings.SerializeAsString() == run->settings().SerializeAsString();
  const bool comparable = estimate.has_model_wall_seconds() && before.model_wall_seconds() > 0;
  if (!same && !comparable) return;
  const double ratio = comparable ? estimate.model_wall_seconds() / before.model_wall_seconds() : 1;
  const double factor = factor_of(evidence, source, history_factor) * (1 + 0.1 * far);
  const std::string basis = "job " + run->job_id() + (same ? ", the same settings" : ", other settings");
  *estimate.mutable_wall_seconds() = figure(ratio * run->cost().wall_seconds(), factor, source, basis);
  *estimate.mutable_core_seconds() = figure(ratio * run->cost().core_seconds(), factor, source, basis);
  if (before.model_steps() > 0)
    *estimate.mutable_steps() =
        figure(estimate.model_steps() * static_cast<double>(run->steps()) / before.model_steps(),
               same ? 1 : 1.1 + 0.1 * far, source, basis);
  if (!same) return;
  *estimate.mutable_memory_bytes() =
      figure(static_cast<double>(run->cost().memory_bytes()), memory_factor, source, basis);
  *estimate.mutable_result_bytes() = figure(static_cast<double>(run->result_bytes()), file_factor, source, basis);
  estimate.clear_missing();
}

void estimate_by_trial(const Model& model, const Evidence& evidence, v1::Estimate& estimate) {
  constexpr auto source = v1::Figure::PROBE;
  if (!evidence.trial) return;
  const v1::Trial& trial = *evidence.trial;
  if (!trial.failure().empty()) {
    estimate.set_missing("the trial run went bad: " + trial.failure());
    return;
  }
  // A search for modes does not show how far it is.
  const bool searches =
      std::holds_alternative<Modal>(model.analysis) || std::holds_alternative<Buckling>(model.analysis);
  if (searches && !trial.whole()) return;
  const double factor = factor_of(evidence, source, trial_factor);
  const v1::Cost& cost = trial.cost();
  *estimate.mutable_steps() = figure(trial.steps(), trial.whole() ? 1 : 1.1, source, trial.basis());
  *estimate.mutable_wall_seconds() = figure(cost.wall_seconds(), factor, source, trial.basis());
  *estimate.mutable_core_seconds() = figure(cost.core_seconds(), factor, source, trial.basis());
  // Counted arrays say more than a process that is new does, but nobody can count factors. What is recorded grows
  // until the end.
  const auto memory = static_cast<double>(cost.memory_bytes());
  const bool counted = estimate.has_memory_bytes();
  const bool exceeds = counted && solves_for_displacements(model) && estimate.memory_bytes().value() < memory;
  if (exceeds || (trial.whole() && !counted))
    *estimate.mutable_memory_bytes() = figure(memory, memory_factor, source, trial.basis());
  if (estimate.has_memory_bytes())
    estimate.clear_missing();
  else
    estimate.set_missing("memory_bytes: this machine has not been measured yet");
}

}  // namespace

int threads_of(const Model& model, int of_worker) { return model.numerics.threads.value_or(of_worker); }

std::int64_t result_bytes(const Model& model) {
  const OutputPlan& outputs = model.outputs;
  const auto columns = static_cast<double>(history_columns(model).size() + 1);
  const double snapshots = outputs.samples_per_snapshot == 0
                               ? 0
                               : static_cast<double>(outputs.samples / outputs.samples_per_snapshot + 1);
  // Numbers, bodies, and the vertices' connectivity and offsets, of snapshots if there are any.
  const double once = snapshots > 0 ? 4 * sizeof(std::int64_t) : 0;
  const double bytes = sizeof(double) * static_cast<double>(outputs.samples + 1) * columns +
                       snapshots * snapshot_bytes(model) + once * static_cast<double>(model.particle_count());
  return static_cast<std::int64_t>(bytes);
}

v1::Estimate estimate(const v1::Scene& scene, const Model& model, const Evidence& evidence) {
  v1::Estimate estimate;
  estimate.set_threads(threads_of(model, evidence.threads));
  const ModelPlan planned = plan(model);
  if (!solves_for_displacements(model))
    *estimate.mutable_time_step() = figure(planned.time_step, 1.1, v1::Figure::MODEL, "at time 0");
  estimate.set_time_step_limit(planned.time_step_limit);
  estimate_by_model(model, planned, evidence, estimate);
  estimate_by_history(settings_of(scene), evidence, estimate);
  estimate_by_trial(model, evidence, estimate);
  *estimate.mutable_queue_seconds() =
      figure(evidence.queue_seconds, 2, v1::Figure::MODEL, "estimates of the jobs in front of it");
  estimate_errors(scene, evidence, estimate);
  return estimate;
}

}  // namespace trajan
