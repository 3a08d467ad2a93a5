#pragma once

#include <optional>
#include <vector>

#include "solver/model/model.h"

namespace trajan {

/// How far a run has come.
struct Moment {
  double share = 0;    ///< of the time that is simulated, 0 to 1
  double steps = 0;    ///< so far, of the scheme or of Newton's method
  double seconds = 0;  ///< of processor time so far
};

/// Moments of a run from its beginning to its end: how steps and their costs are spread over the time.
using Course = std::vector<Moment>;

/// Runs a model by one thread without recording anything; nothing if it goes bad or takes more than so many
/// seconds of wall time.
std::optional<Course> run_course(const Model& model, double seconds);

/// What a course has spent at a share of the time, as shares of all its steps and seconds.
Moment spent(const Course& course, double share);

}  // namespace trajan
