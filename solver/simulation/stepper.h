#pragma once

#include <cstdint>
#include <vector>

#include "solver/recorder.h"

namespace trajan {

/// How time advances where it is not by a scheme's explicit steps.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Does a piece of work towards a time, after which a run may stop. True: the time is reached. `number` counts
  /// these pieces. Throws Diverged.
  virtual bool advance(double until, std::int64_t number) = 0;
  virtual double time() const = 0;
  /// Pieces of work until the end, as far as one can tell.
  virtual std::int64_t steps_left() const = 0;
  /// Appends its own columns of the row of histories.
  virtual void record(std::vector<double>&) const {}
  /// What makes answers doubtful before the first piece of work.
  virtual std::vector<Warning> warnings() const { return {}; }
  /// Adds what it needs to go on from the sample that has just been reached.
  virtual void save(Checkpoint& checkpoint) const = 0;
};

}  // namespace trajan
