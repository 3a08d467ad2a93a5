#pragma once

#include <cstdint>
#include <string>

#include "solver/simulation/executor.h"
#include "solver/simulation/stepper.h"

namespace trajan {

struct Scheme;

/// Finds states of rest under loads that stand still, by the explicit scheme and kinetic damping (Cundall 1976;
/// Barnes 1988): particles move freely until their kinetic energy has passed a maximum, where strain energy
/// is near a minimum, and are then stopped; what is left of the unbalanced forces moves them again. Inertia of
/// bodies is chosen so that waves are equally fast in all of them, which is what one time step for all needs.
class DynamicRelaxation : public Stepper {
 public:
  DynamicRelaxation(const Model& model, const Relaxation& limits, Executor& executor, const Checkpoint* resume);

  /// Takes a step under the loads of the time `until`; true: forces are in balance and all particles at rest.
  bool advance(double until, std::int64_t number) override;
  std::vector<Warning> warnings() const override;
  /// As far from the last level to the next as the residual has come to the tolerance, on a logarithmic scale.
  double time() const override;
  std::int64_t steps_left() const override;
  void record(std::vector<double>& columns) const override;
  void save(Checkpoint& checkpoint) const override;

 private:
  void begin_level();
  void step();
  void measure();
  bool is_settled();
  void halt();
  void find_time_step();
  void watch_progress(bool peak);
  [[noreturn]] void give_up(Divergence divergence) const;

  const Model& model_;
  const Scheme& scheme_;
  const Relaxation& limits_;
  Executor& executor_;
  double from_ = 0, until_ = 0;  ///< times of the last level and of the present one
  double time_step_ = 0;
  bool at_rest_ = true;
  /// Unbalanced forces over external ones, or where there are none over the first unbalanced ones of the level:
  /// norms over all nodes.
  double residual_ = 0;
  double first_unbalanced_ = 0;
  std::int64_t number_ = 0, steps_of_level_ = 0, steps_of_last_level_ = 0;
  double smallest_ = 1;  ///< residual of the level
  /// The least residual of the level that halved the one before, when it was last improved upon, and how many
  /// peaks there were since.
  double least_ = 1;
  std::int64_t least_at_ = 0, peaks_since_ = 0, last_peak_ = 0;
  double crossing_time_;     ///< of the slowest waves through the longest body
  std::string free_motion_;  ///< of what nothing holds at the beginning; empty: none
};

}  // namespace trajan
