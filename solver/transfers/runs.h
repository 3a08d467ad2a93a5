#pragma once

#include "solver/executors/block.h"
#include "solver/transfers/intrinsics.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Where runs of consecutive particles with the same nodes begin and, after the last one, where it ends. Particles
/// are ordered by their stencils: what is the same for a run is done once. Runs are found before any is worked on,
/// for a processor that guesses where the next one ends guesses wrong once a run in a body that drifts.
struct Runs {
  std::int32_t begin[block_size + 16];
  int count;

  explicit Runs(const Block& block) {
    begin[0] = 0;
    count = 1 + find_changes(block.scratch->cell, block.count, begin + 1);
    begin[count] = block.count;
  }
};

/// Calls of(begin, end, first node) for every run.
template <class Function>
__attribute__((always_inline)) inline void for_each_run(const Block& block, Function&& of) {
  const Runs runs(block);
  for (int run = 0; run < runs.count; ++run)
    of(runs.begin[run], runs.begin[run + 1], block.scratch->cell[runs.begin[run]]);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
