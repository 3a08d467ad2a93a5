#include "solver/simulation/simulation.h"

#include <algorithm>
#include <cmath>

#include "solver/implicit/steppers.h"
#include "solver/schemes/schemes.h"
#include "solver/schemes/time_step.h"
#include "solver/simulation/diverged.h"

namespace trajan {
namespace {

/// A run in which this part of all the energy that ever went into it has come from nowhere is not stable. Stable
/// ones stay at some hundredths; instability multiplies energies, so that the bound only decides how early it is
/// seen.
constexpr double most_energy_from_nowhere = 0.5;
/// From here on numbers are doubtful: velocities are off by half as much.
constexpr double doubtful_energy_from_nowhere = 0.05;

}  // namespace

Simulation::Simulation(const Model& model, int threads)
    : model_(model),
      scheme_(*find_scheme(model.numerics.scheme)),
      executor_(model, threads),
      fields_(model, executor_),
      coherence_(model, executor_) {
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

bool Simulation::step() {
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
  from_nowhere_ = largest_input_ > 0 ? from_nowhere / largest_input_ : 0.0;
  if (from_nowhere <= most_energy_from_nowhere * largest_input_) return;
  executor_.diverge("energy has come from nowhere, " + std::to_string(from_nowhere_) +
                        " times what went in: the motion is not stable",
                    "take a smaller numerics.time_step_fraction");
}

std::optional<Warning> Simulation::warning() {
  if (from_nowhere_ > doubtful_energy_from_nowhere && !told_of_energy_) {
    told_of_energy_ = true;
    Warning warning;
    warning.step = steps_;
    warning.time = time();
    warning.cause = "energy has come from nowhere, " + std::to_string(from_nowhere_) + " times what went in";
    warning.remedy =
        "take a smaller numerics.time_step_fraction, smoother numerics.shape_functions or a transfer that smooths";
    return warning;
  }
  return coherence_.check(steps_, time(), sample_ == model_.outputs.samples);
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
