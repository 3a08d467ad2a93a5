#pragma once

#include <cstdint>

namespace trajan {

/// How many runs of consecutive particles with the same nodes there are, and were when particles had been sorted.
struct ParticleOrder {
  std::int64_t sorted = 0, now = 0;
  void count(std::int64_t runs) {
    now = runs;
    if (sorted == 0) sorted = runs;
  }
  bool is_worn() const { return static_cast<double>(now) > worn * static_cast<double>(sorted); }
  /// Particles that drift get out of order before they leave their tiles, and what is done once for a run is done
  /// ever more often. With so many times the runs, sorting costs less than it saves.
  static constexpr double worn = 1.5;
};

}  // namespace trajan
