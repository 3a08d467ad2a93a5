#pragma once

#include <cstdint>
#include <vector>

#include "tests/bench/cases.h"

namespace trajan::bench {

struct Measurement {
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  std::vector<double> nanoseconds;  ///< per particle and step, one for each repetition
  double start = 0;                 ///< seconds from the scene to the end of the first step
  double validation = 0;            ///< those of them until there is a model
  std::int64_t solver_bytes = 0;
  std::int64_t peak_bytes = 0;  ///< of the process
  double bytes_moved = 0;       ///< per particle and step, by counting
  double multiply_adds = 0;     ///< per particle and step, by counting those of the transfers alone
};

/// To be called once in a process, whose peak of memory it reports. Explicit steps are repeated; of other analyses
/// the whole run is measured once.
Measurement measure(const Case& of, double particles, int threads);

}  // namespace trajan::bench
