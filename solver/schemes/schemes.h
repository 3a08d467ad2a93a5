#pragma once

#include <string_view>

namespace trajan {

class Executor;
struct StepTimes;

/// How a step is taken.
struct Scheme {
  std::string_view name;
  /// Shape functions stay with the reference positions, and nothing is ever sorted again.
  bool total_lagrangian;
  void (*step)(Executor&, const StepTimes&);
};

/// nullptr: there is no scheme of that name.
const Scheme* find_scheme(std::string_view name);

/// Brings velocities to the same time as positions by half a step's kick. Leapfrog velocities belong to
/// the middle of steps: an interval between samples begins with half a kick and ends with this one.
void synchronise(Executor&, const StepTimes&);

}  // namespace trajan
