#pragma once

#include "solver/transfers/find_ends.h"
#include "solver/transfers/real.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// To be called once cells are known.
inline void find_runs(Block& block) {
  RealScratch& s = scratch_of(block);
  s.run_begin[0] = 0;
  s.runs = 1 + find_ends<Changes>(s.cell, block.count, s.run_begin + 1);
  s.run_begin[s.runs] = block.count;
}

/// Where strips have been found runs have not: shape functions that have strips may be used beside others of their
/// particles that have none.
inline void know_runs(Block& block) {
  if (scratch_of(block).runs == 0) find_runs(block);
}

/// Calls of(begin, end, first node) for every second run, then for the others. What two that follow each other add
/// to nodes overlaps, and a processor that has just written something reads it at once only if it is the same
/// bytes; otherwise it waits for the cache, by a profile a third of the time of scattering momentum in a plane
/// with linear functions.
template <class Function>
__attribute__((always_inline)) inline void for_each_run(const RealScratch& s, Function&& of) {
  for (int first = 0; first < 2; ++first)
    for (int run = first; run < s.runs; run += 2)
      of(s.run_begin[run], s.run_begin[run + 1], s.cell[s.run_begin[run]]);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
