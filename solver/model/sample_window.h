#pragma once

#include <cstdint>

#include "solver/scene/scene.h"

namespace trajan {

/// Samples first <= i <= last.
struct SampleWindow {
  std::int64_t first = 0;
  std::int64_t last = -1;
  std::int64_t count() const { return last - first + 1; }
};

/// The samples whose times i * end_time / samples lie in [from, until], to 1e-9 of an interval.
/// Precondition: finite numbers, end_time > 0, samples > 0.
SampleWindow sample_window(double from, double until, double end_time, std::int64_t samples);

/// A spectrum of fewer samples has no peak worth the name.
inline constexpr std::int64_t fewest_samples_of_a_spectrum = 16;

}  // namespace trajan
