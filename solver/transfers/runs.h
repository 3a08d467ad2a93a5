#pragma once

#include "solver/executors/block.h"
#include "solver/transfers/real.h"
#include "solver/transfers/vectors.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Particles are ordered by their stencils: what is the same for a run of consecutive particles with the same
/// nodes is done once. Calls of(begin, end, first node) for every run.
template <class Function>
__attribute__((always_inline)) inline void for_each_run(const Block& block, Function&& of) {
  const std::int64_t* cell = block.scratch->cell;
  for (int begin = 0; begin < block.count;) {
    int end = begin + 1;
    while (end < block.count && cell[end] == cell[begin]) ++end;
    of(begin, end, cell[begin]);
    begin = end;
  }
}

inline std::int64_t count_runs(const Block& block) {
  const std::int64_t* cell = block.scratch->cell;
  std::int64_t runs = block.count > 0;
  for (int i = 1; i < block.count; ++i) runs += cell[i] != cell[i - 1];
  return runs;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
