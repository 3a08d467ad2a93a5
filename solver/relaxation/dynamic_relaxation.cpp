#include "solver/relaxation/dynamic_relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "solver/implicit/rigid_modes.h"
#include "solver/schemes/scheme.h"
#include "solver/schemes/schemes.h"
#include "solver/schemes/time_step.h"
#include "solver/simulation/diverged.h"
#include "solver/simulation/fastest_particle.h"

namespace trajan {
namespace {

/// Wave speeds change as bodies deform: the time step is found again after so many steps.
constexpr std::int64_t steps_per_time_step = 64;

/// A level is stuck if for so many maxima of the kinetic energy, and for so many times the steps that it took to
/// the least residual, that has not become less by this share. Levels that converge improve by more with each
/// maximum or two.
constexpr std::int64_t most_vain_peaks = 100, most_vain_times = 3;
constexpr double least_improvement = 0.5;

/// A body that vibrates comes to a maximum of its kinetic energy within a quarter of its longest period, which is
/// about a quarter as many crossings of its waves as the body is slender. One that moves for so many without any
/// is driven away.
constexpr double most_crossings = 64;

/// Slows the waves of all bodies down to the slowest one's, and returns how fast that is.
double equalise_waves(const Model& model, Executor& executor) {
  const auto speed = [&](const Body& body) {
    const Material& material = model.materials[body.material];
    return material.kind->wave_speed(material.parameters, material.density, model.dimension);
  };
  double slowest = std::numeric_limits<double>::infinity();
  for (const Body& body : model.bodies) slowest = std::min(slowest, speed(body));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const double ratio = speed(model.bodies[b]) / slowest;
    if (ratio > 1) executor.scale_inertia(b, ratio * ratio);
  }
  return slowest;
}

double longest_side(const Model& model) {
  double longest = 0;
  for (const Body& body : model.bodies) {
    const Lattice& lattice = body.lattice;
    longest = std::max({longest, static_cast<double>(lattice.columns) * lattice.spacing.x,
                        static_cast<double>(lattice.rows) * lattice.spacing.y,
                        static_cast<double>(lattice.planes) * lattice.spacing.z});
  }
  return longest;
}

/// Whether something may hold a body that is not a displacement which is prescribed.
bool may_be_stopped(const Model& model) {
  const auto prescribes = [](const BoundaryCondition& condition) {
    return std::holds_alternative<PrescribedMotion>(condition.kind) ||
           std::holds_alternative<HeldSurface>(condition.kind);
  };
  return model.contacts.fields > 1 || !std::ranges::all_of(model.conditions, prescribes);
}

std::string remedy_of_stuck(const Model& model) {
  const std::string larger = "accept a larger analysis.relaxation.tolerance, or ";
  if (has_contact(model))
    return larger +
           "load slowly in explicit dynamics with analysis.damping: nodes at which bodies meet touch and "
           "part again while all else is nearly at rest";
  if (is_total_lagrangian(model.numerics.scheme) || model.numerics.shape_functions != "linear")
    return larger +
           "take one more of bodies.particles_per_cell_side, or analysis.quasi_static: nodes that particles of a "
           "surface hardly reach come to rest last";
  return larger +
         "choose numerics.scheme: \"TLMPM\" or smooth shape functions, by which particles that cross cells "
         "make no noise";
}

}  // namespace

DynamicRelaxation::DynamicRelaxation(const Model& model, const Relaxation& limits, Executor& executor,
                                     const Checkpoint* resume)
    : model_(model), scheme_(*find_scheme(model.numerics.scheme)), limits_(limits), executor_(executor) {
  if (resume) from_ = until_ = resume->time;
  executor_.account().watch_forces(executor_.tiles().tiles().size());
  crossing_time_ = longest_side(model) / equalise_waves(model, executor_);
}

double DynamicRelaxation::time() const {
  return std::lerp(from_, until_, std::clamp(std::log(least_) / std::log(limits_.tolerance), 0.0, 1.0));
}

std::int64_t DynamicRelaxation::steps_left() const {
  const double levels = static_cast<double>(model_.outputs.samples) * (1 - until_ / model_.end_time);
  const std::int64_t of_each = std::max(steps_of_level_, steps_of_last_level_);
  return static_cast<std::int64_t>(levels + 0.5) * of_each + of_each - steps_of_level_;
}

void DynamicRelaxation::record(std::vector<double>& columns) const {
  columns.insert(columns.end(), {residual_, static_cast<double>(steps_of_last_level_)});
}

/// At a sample everything is at rest: there is nothing to remember.
void DynamicRelaxation::save(Checkpoint&) const {}

void DynamicRelaxation::begin_level() {
  at_rest_ = true;
  kinetic_energy_ = first_unbalanced_ = 0;
  steps_of_level_ = least_at_ = peaks_since_ = last_peak_ = 0;
  least_ = 1;
}

bool DynamicRelaxation::advance(double until, std::int64_t number) {
  if (until != until_) begin_level();
  until_ = until;
  number_ = number;
  if (steps_of_level_ % steps_per_time_step == 0) find_time_step();
  step();
  measure();
  if (residual_ <= limits_.tolerance) {
    if (!is_settled()) {
      watch_progress(true);
      return false;
    }
    from_ = until_;
    steps_of_last_level_ = steps_of_level_;
    return true;
  }
  const double energy = executor_.account().balance().kinetic_energy;
  const bool peak = !at_rest_ && energy < kinetic_energy_;
  at_rest_ = false;
  kinetic_energy_ = energy;
  if (peak) halt();
  watch_progress(peak);
  return false;
}

void DynamicRelaxation::find_time_step() {
  const Totals totals = executor_.totals();
  time_step_ = model_.numerics.time_step ? *model_.numerics.time_step
                                         : model_.numerics.time_step_fraction *
                                               stable_time_step(model_, std::sqrt(totals.squared_wave_speed),
                                                                std::sqrt(totals.squared_speed));
}

void DynamicRelaxation::step() {
  StepTimes times;
  times.step = number_;
  times.time = until_;
  times.before = at_rest_ ? until_ : until_ - 0.5 * time_step_;
  times.after = until_ + 0.5 * time_step_;
  times.drift = time_step_;
  scheme_.step(executor_, times);
  ++steps_of_level_;
}

void DynamicRelaxation::measure() {
  const ForceBalance& balance = executor_.account().balance();
  const double unbalanced = std::sqrt(balance.unbalanced), external = std::sqrt(balance.external);
  if (first_unbalanced_ == 0) first_unbalanced_ = unbalanced;
  const double scale = external > 0 ? external : first_unbalanced_;
  residual_ = scale > 0 ? unbalanced / scale : 0;
}

/// Velocities first catch up with the places of the particles: without the half kick the energies of two times
/// would be compared, and work of half a step at the greatest speed be missing.
void DynamicRelaxation::halt() {
  StepTimes times;
  times.step = number_;
  times.time = times.after = until_;
  times.before = until_ - 0.5 * time_step_;
  synchronise(executor_, times);
  executor_.halt();
  at_rest_ = true;
  kinetic_energy_ = 0;
}

/// The forces were those of the places before the step: looks again where the particles are now, at rest.
bool DynamicRelaxation::is_settled() {
  halt();
  const Exchanged exchanged = executor_.account().exchanged();
  executor_.account().forget_reactions();
  StepTimes times;
  times.step = number_;
  times.time = times.before = until_;
  times.after = until_ + 0.5 * time_step_;
  executor_.particles({Pass::locate, Pass::force, Pass::scatter_state});
  executor_.update_velocities(times);
  executor_.account().restore(exchanged);
  // The force at the sample is recorded as if it had been there since the last one.
  const double interval = model_.end_time / static_cast<double>(model_.outputs.samples);
  for (Reaction& reaction : executor_.account().reactions())
    for (double& impulse : reaction.impulse) impulse *= interval / (times.after - times.before);
  measure();
  return residual_ <= limits_.tolerance;
}

void DynamicRelaxation::watch_progress(bool peak) {
  peaks_since_ += peak;
  if (peak) last_peak_ = steps_of_level_;
  if (static_cast<double>(steps_of_level_ - last_peak_) * time_step_ > most_crossings * crossing_time_) {
    last_peak_ = steps_of_level_;  // a body that is held is given as much time again
    refuse_free_motion();
  }
  if (residual_ < (1 - least_improvement) * least_) {
    least_ = residual_;
    least_at_ = steps_of_level_;
    peaks_since_ = 0;
  }
  const bool stuck = peaks_since_ > most_vain_peaks && steps_of_level_ > (1 + most_vain_times) * least_at_;
  if (!stuck && steps_of_level_ < limits_.most_steps) return;
  refuse_free_motion();
  std::ostringstream cause;
  cause << (stuck ? "the relaxation is stuck" : "the relaxation has not come to rest") << " after "
        << steps_of_level_ << " steps of a load level: unbalanced forces are " << residual_
        << " of the external ones, at best " << least_;
  const Slot fastest = fastest_particle(executor_, grid_axes(model_.dimension));
  throw Diverged({number_, until_, particle_number(model_, executor_, fastest), cause.str(),
                  stuck ? remedy_of_stuck(model_)
                        : "allow more analysis.relaxation.most_steps; a body that no boundary holds never rests"});
}

void DynamicRelaxation::refuse_free_motion() {
  if (may_be_stopped(model_)) return;
  executor_.finish();
  const Discretization on(model_, executor_);
  const std::string motion = find_free_motion(model_, on, Constraints(on, executor_, until_, until_));
  if (!motion.empty())
    throw Diverged({number_, until_, -1,
                    motion + ": nothing holds it, and after " + std::to_string(steps_of_level_) +
                        " steps of a load level it has not come to rest",
                    "hold it by a boundary condition, or choose a dynamic analysis"});
}

}  // namespace trajan
