#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "solver/recorder.h"
#include "solver/simulation/angular_momentum.h"
#include "solver/simulation/coherence.h"
#include "solver/simulation/executor.h"
#include "solver/simulation/particle_fields.h"
#include "solver/simulation/stepper.h"

namespace trajan {

struct Scheme;

/// A model in motion. Time goes from sample to sample: sample i is at i * end_time / samples. All that it
/// gives is of the present sample: positions, velocities and forces belong to its time (between samples
/// velocities are half a step off, as leapfrog's are). Its bits do not depend on the number of threads.
class Simulation {
 public:
  /// At sample 0.
  Simulation(const Model& model, int threads);
  /// At the sample of a checkpoint that `save` made for the same model.
  Simulation(const Model& model, int threads, const Checkpoint& checkpoint);

  /// Goes on by one step; true if that reached the next sample. Throws Diverged.
  bool step();

  std::int64_t sample() const { return sample_; }
  std::int64_t steps() const { return steps_; }
  double time() const;
  /// Steps until the end if the time step stays what it is.
  std::int64_t steps_left() const;

  /// \name Only at a sample
  /// @{
  /// The row of histories, columns as history_columns(model).
  const std::vector<double>& columns() const { return columns_; }
  Snapshot snapshot();
  Checkpoint save();
  /// What has gone wrong since, as far as anybody has looked; each thing is said once.
  std::vector<Warning> warnings();
  /// @}

  double energy_balance_error() const { return balance_error_; }
  const Executor& executor() const { return executor_; }

 private:
  double sample_time(std::int64_t sample) const;
  double last_interval() const;
  void begin_interval();
  bool advance();
  bool step_explicitly();
  Divergence explained(Divergence divergence);
  void measure();
  double common_energy() const;
  bool is_free_motion() const;
  std::optional<Warning> energy_warning();
  void probe();
  void follow_probes();
  /// A field's columns of a probe, whose particles are those from `first` on of all probed ones.
  void record(const Probe& probe, const RecordedField& field, std::size_t first);

  const Model& model_;
  const Scheme& scheme_;
  Executor executor_;
  ParticleFields fields_;
  Coherence coherence_;
  AngularMomentum angular_momentum_;
  std::unique_ptr<Stepper> stepper_;  ///< nullptr: steps are the scheme's
  std::int64_t sample_ = 0, steps_ = 0;
  std::int64_t step_in_interval_ = 0, steps_in_interval_ = 0;
  double time_step_ = 0;
  Totals totals_;
  double initial_energy_ = 0, largest_energy_ = 0, balance_error_ = 0;
  double largest_input_ = 0;            ///< of initial energy and work so far
  double internal_energy_ = 0;          ///< in strains and relative motion
  double largest_internal_energy_ = 0;  ///< or work
  double from_nowhere_ = 0;             ///< energy that neither went in nor was there, over that
  bool told_of_energy_ = false;
  std::vector<double> columns_;
  /// Probed particles in the order of the scene, with their reference positions and places in memory.
  std::vector<std::int64_t> probed_;
  std::vector<Vector> probed_reference_;
  std::vector<Slot> probed_slots_;
  std::int64_t probed_sortings_ = -1;
};

}  // namespace trajan
