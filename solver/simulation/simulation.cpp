#include "solver/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/implicit/steppers.h"
#include "solver/model/names.h"
#include "solver/schemes/scheme.h"
#include "solver/schemes/schemes.h"
#include "solver/schemes/time_step.h"
#include "solver/simulation/diverged.h"
#include "solver/simulation/fastest_particle.h"
#include "solver/simulation/locking.h"
#include "solver/simulation/soft_supports.h"

namespace trajan {
namespace {

/// A run in which this part of all the energy that ever went into it has come from nowhere is not stable. Stable
/// ones stay at some hundredths; instability multiplies energies, so that the bound only decides how early it is
/// seen.
constexpr double most_energy_from_nowhere = 0.5;
/// From here on numbers are doubtful: velocities are off by half as much. What is lost disturbs less, and some
/// schemes and transfers always lose some.
struct Doubt {
  double from_nowhere, lost;
};
constexpr Doubt of_motion = {0.03, 0.15};
/// Where nothing does work, collides or is smoothed all energy is known.
constexpr Doubt of_free_motion = {0.02, 0.02};
/// Work along load steps is added up by the trapezoidal rule; one that jumps to another equilibrium loses far
/// more.
constexpr Doubt of_load_steps = {0.05, 0.2};
/// Of all energy; less of it in strains and relative motion is mere rounding, grown over a run.
constexpr double least_internal_energy = 1e-6;

/// Whether the energies of a run mean anything: a relaxation makes inertia as it likes, and PIC is taken to lose
/// them.
bool keeps_energy(const Model& model) {
  const bool takes = model.numerics.transfer == "PIC" || model.numerics.flip_fraction.value_or(1) < 1;
  return !std::holds_alternative<Relaxation>(model.analysis) && !takes;
}

/// What helps where energy comes from nowhere or goes there.
std::string remedy_of_energy(const Model& model, bool lost = false) {
  const Numerics& numerics = model.numerics;
  if (lost && numerics.transfer != "FLIP")
    return "take smaller cells, or numerics.transfer: \"FLIP\", which smooths nothing";
  if (numerics.scheme == "USL")
    return "choose numerics.scheme: \"MUSL\": nodes of next to no mass are not safe in \"USL\", which loses "
           "energy too";
  if (numerics.shape_functions == "linear" && !is_total_lagrangian(numerics.scheme))
    return "choose numerics.shape_functions: \"quadratic_bspline\" or numerics.scheme: \"TLMPM\": gradients of "
           "linear functions jump where particles enter other cells";
  if (numerics.scheme == "MUSL" || numerics.scheme == "USF")
    return "choose numerics.scheme: \"USAVG\", which errs less, \"TLMPM\", or a smaller "
           "numerics.time_step_fraction: half of it makes a quarter";
  return "take a smaller numerics.time_step_fraction or smaller cells; where strains are large, a law of finite "
         "strain such as \"neo_hookean\", for those in rate form have no energy of their own";
}

}  // namespace

Simulation::Simulation(const Model& model, int threads)
    : model_(model),
      scheme_(*find_scheme(model.numerics.scheme)),
      executor_(model, threads),
      fields_(model, executor_),
      coherence_(model, executor_),
      angular_momentum_(model, executor_) {
  executor_.begin();
  stepper_ = make_stepper(model, executor_);
  follow_probes();
  totals_ = executor_.totals();
  initial_energy_ = totals_.kinetic_energy + totals_.strain_energy;
  measure();
}

double Simulation::sample_time(std::int64_t sample) const {
  if (sample == model_.outputs.samples) return model_.end_time;
  return model_.end_time * static_cast<double>(sample) / static_cast<double>(model_.outputs.samples);
}

double Simulation::time() const {
  if (stepper_) return stepper_->time();
  return sample_time(sample_) + static_cast<double>(step_in_interval_) * time_step_;
}

std::int64_t Simulation::steps_left() const {
  if (stepper_) return stepper_->steps_left();
  const std::int64_t intervals = model_.outputs.samples - sample_;
  return intervals * std::max<std::int64_t>(steps_in_interval_, 1) - step_in_interval_;
}

double Simulation::last_interval() const {
  return sample_time(std::max<std::int64_t>(sample_, 1)) - sample_time(std::max<std::int64_t>(sample_ - 1, 0));
}

void Simulation::begin_interval() {
  executor_.account().forget_reactions();
  const double interval = sample_time(sample_ + 1) - sample_time(sample_);
  const double largest =
      model_.numerics.time_step
          ? *model_.numerics.time_step
          : model_.numerics.time_step_fraction *
                stable_time_step(model_, std::sqrt(totals_.squared_wave_speed), std::sqrt(totals_.squared_speed));
  // A step that divides the interval but for rounding must not become one step more.
  steps_in_interval_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(interval / largest - 1e-9)));
  time_step_ = interval / static_cast<double>(steps_in_interval_);
}

/// What looks like a wild particle is often one of a body that has come apart.
Divergence Simulation::explained(Divergence divergence) {
  if (stepper_) return divergence;
  const std::vector<Warning> broken = coherence_.check(steps_, divergence.time, true);
  if (broken.empty()) return divergence;
  divergence.cause += ": " + broken[0].cause;
  divergence.remedy += "; or, since " + broken[0].remedy;
  return divergence;
}

bool Simulation::step() {
  try {
    return advance();
  } catch (const Diverged& diverged) {
    throw Diverged(explained(diverged.divergence()));
  }
}

bool Simulation::advance() {
  if (!(stepper_ ? stepper_->advance(sample_time(sample_ + 1), steps_++) : step_explicitly())) return false;
  ++sample_;
  totals_ = executor_.totals();
  measure();
  return true;
}

/// True: the next sample is reached.
bool Simulation::step_explicitly() {
  if (step_in_interval_ == 0) begin_interval();
  const bool first = step_in_interval_ == 0;
  StepTimes times;
  times.step = steps_;
  times.time = time();
  times.before = first ? times.time : times.time - 0.5 * time_step_;
  times.after = times.time + 0.5 * time_step_;
  times.drift = time_step_;
  scheme_.step(executor_, times);
  ++steps_;
  ++step_in_interval_;
  if (step_in_interval_ < steps_in_interval_) return false;

  step_in_interval_ = 0;
  times.time = sample_time(sample_ + 1);
  times.before = times.time - 0.5 * time_step_;
  times.after = times.time;
  times.drift = 0;
  times.step = steps_;
  synchronise(executor_, times);
  return true;
}

void Simulation::measure() {
  columns_.clear();
  probe();
  const double total = totals_.kinetic_energy + totals_.strain_energy;
  const Exchanged& exchanged = executor_.account().exchanged();
  const double work = exchanged.work, dissipated = exchanged.dissipated + totals_.dissipated_energy;
  for (double term : {total, work, dissipated, initial_energy_})
    largest_energy_ = std::max(largest_energy_, std::abs(term));
  const double from_nowhere = total + dissipated - work - initial_energy_;
  balance_error_ = largest_energy_ > 0 ? from_nowhere / largest_energy_ : 0.0;
  columns_.insert(columns_.end(),
                  {totals_.kinetic_energy, totals_.strain_energy, work, dissipated, total, balance_error_});
  if (has_contact(model_)) columns_.push_back(exchanged.contact);
  const auto axes = static_cast<std::size_t>(grid_axes(model_.dimension));
  columns_.insert(columns_.end(), totals_.momentum, totals_.momentum + axes);
  const auto record_force = [&](const Reaction& reaction) {
    for (std::size_t axis = 0; axis < axes; ++axis) columns_.push_back(reaction.impulse[axis] / last_interval());
  };
  const std::span<const Reaction> reactions = executor_.account().reactions();
  for (std::size_t condition : model_.outputs.reactions) record_force(reactions[condition]);
  for (const Reaction& of_body : reactions.subspan(model_.conditions.size())) record_force(of_body);
  if (stepper_) stepper_->record(columns_);
  largest_input_ = std::max({largest_input_, std::abs(initial_energy_), std::abs(work)});
  internal_energy_ =
      std::max(least_internal_energy * largest_energy_, total - common_energy() - std::max(from_nowhere, 0.0));
  largest_internal_energy_ = std::max({largest_internal_energy_, std::abs(work), internal_energy_});
  from_nowhere_ = largest_internal_energy_ > 0 ? from_nowhere / largest_internal_energy_ : 0.0;
  if (from_nowhere <= most_energy_from_nowhere * largest_input_) return;
  executor_.diverge("energy has come from nowhere, " + std::to_string(from_nowhere / largest_input_) +
                        " times what went in: the motion is not stable",
                    remedy_of_energy(model_));
}

/// Of a motion of all particles together, in which nothing can go wrong.
double Simulation::common_energy() const {
  double square = 0;
  for (int axis = 0; axis < grid_axes(model_.dimension); ++axis) {
    const bool radial = model_.dimension == Dimension::axisymmetric && axis == 0;
    if (!radial) square += totals_.momentum[axis] * totals_.momentum[axis];
  }
  double mass = 0;
  for (const BodyParticles& body : executor_.bodies()) {
    const std::vector<double>& volumes = body[Attribute::reference_volume];
    mass += volumes.empty() ? body.constants.mass * static_cast<double>(body.size())
                            : body.constants.density * std::accumulate(volumes.begin(), volumes.end(), 0.0);
  }
  return 0.5 * square / mass;
}

/// Of one body by itself. USL always takes some energy.
bool Simulation::is_free_motion() const {
  return model_.bodies.size() == 1 && !has_contact(model_) && executor_.account().exchanged().work == 0 &&
         model_.numerics.transfer == "FLIP" && model_.numerics.scheme != "USL";
}

std::optional<Warning> Simulation::energy_warning() {
  const bool statics = std::holds_alternative<QuasiStatic>(model_.analysis);
  const Doubt& doubt = statics ? of_load_steps : is_free_motion() ? of_free_motion : of_motion;
  const bool doubtful = from_nowhere_ > doubt.from_nowhere || from_nowhere_ < -doubt.lost;
  if (told_of_energy_ || !doubtful || !keeps_energy(model_)) return std::nullopt;
  told_of_energy_ = true;
  const Slot fastest = fastest_particle(executor_, grid_axes(model_.dimension));
  Warning warning;
  warning.name = "energy";
  warning.step = steps_;
  warning.time = time();
  warning.particle = particle_number(model_, executor_, fastest);
  warning.place = fields_.position(fastest);
  warning.cause = from_nowhere_ > 0 ? "energy has come from nowhere, " : "energy is missing, ";
  warning.cause += std::to_string(std::abs(from_nowhere_)) + " times what is in strains and relative motion";
  if (statics && from_nowhere_ < 0) {
    warning.cause += ": body " + quoted(model_.bodies[fastest.body].name) +
                     " or another one jumps to another equilibrium, or load steps are too long";
    warning.remedy = "take more analysis.quasi_static.load_steps, or trace the path by arc_length";
  } else {
    warning.remedy = remedy_of_energy(model_, from_nowhere_ < 0);
  }
  return warning;
}

std::vector<Warning> Simulation::warnings() {
  std::vector<Warning> all;
  const auto add = [&all](const std::vector<Warning>& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (sample_ == 0) {
    if (stepper_) add(stepper_->warnings());
    add(warnings_of_locking(model_));
    add(warnings_of_soft_supports(model_));
  }
  if (std::optional<Warning> energy = energy_warning()) all.push_back(*energy);
  if (std::optional<Warning> spin = angular_momentum_.check(steps_, time(), internal_energy_))
    all.push_back(*spin);
  add(coherence_.check(steps_, time(), sample_ == model_.outputs.samples));
  return all;
}

void Simulation::follow_probes() {
  if (probed_sortings_ == executor_.sortings()) return;
  if (probed_sortings_ < 0) {
    for (const Probe& probe : model_.outputs.probes)
      probed_.insert(probed_.end(), probe.particles.begin(), probe.particles.end());
    probed_reference_ = reference_positions(model_, probed_);
  }
  probed_slots_ = find_slots(executor_.bodies(), model_, probed_);
  probed_sortings_ = executor_.sortings();
}

void Simulation::probe() {
  follow_probes();
  std::size_t first = 0;
  for (const Probe& probe : model_.outputs.probes) {
    for (const RecordedField& field : probe.fields) record(probe, field, first);
    first += probe.particles.size();
  }
}

void Simulation::record(const Probe& probe, const RecordedField& field, std::size_t first) {
  std::array<double, most_components> value, result{};
  double weights = 0;
  for (std::size_t p = first; p < first + probe.particles.size(); ++p) {
    fields_.read(field, probed_slots_[p], probed_reference_[p], value);
    // A single particle's values go through without rounding.
    const double weight = probe.particles.size() > 1 ? fields_.reference_volume(probed_slots_[p]) : 1.0;
    for (std::size_t c = 0; c < field.width(); ++c) {
      if (probe.statistic == Statistic::mean)
        result[c] += weight * value[c];
      else if (p == first || (value[c] > result[c]) == (probe.statistic == Statistic::largest))
        result[c] = value[c];
    }
    weights += weight;
  }
  if (probe.statistic != Statistic::mean) weights = 1;
  for (std::size_t c = 0; c < field.width(); ++c) columns_.push_back(result[c] / weights);
}

}  // namespace trajan
