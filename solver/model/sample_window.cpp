#include "solver/model/sample_window.h"

#include <algorithm>
#include <cmath>

namespace trajan {

SampleWindow sample_window(double from, double until, double end_time, std::int64_t samples) {
  constexpr double tolerance = 1e-9;
  const double most = static_cast<double>(samples);
  const double first = std::ceil(from / end_time * most - tolerance);
  const double last = std::floor(until / end_time * most + tolerance);
  return {static_cast<std::int64_t>(std::clamp(first, 0.0, most + 1)),
          static_cast<std::int64_t>(std::clamp(last, -1.0, most))};
}

}  // namespace trajan
