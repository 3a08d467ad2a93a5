#pragma once

#include "solver/executors/instruction_set.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Piecewise linear functions averaged over the particle's domain, along one axis: the weight of a node at the
/// distance p - n is (H(p - n + l) - H(p - n - l)) / (2 l), H the integral of the hat function and l the half
/// size of the particle in cells (the integral of Bardenhagen and Kober 2004 in closed form for any l).
template <int Nodes>
inline void average_hats(Real p, Real half_size, Real (&weight)[Nodes], Real (&slope)[Nodes]) {
  const Real factor = Real(0.5) / half_size;
  for (int n = 0; n < Nodes; ++n) {
    const Real from = p - Real(n) - half_size, to = p - Real(n) + half_size;
    const Real a = from < -1 ? -1 : from > 1 ? 1 : from;
    const Real b = to < -1 ? -1 : to > 1 ? 1 : to;
    const Real size_a = a < 0 ? -a : a, size_b = b < 0 ? -b : b;
    weight[n] = factor * ((b - a) - (b * size_b - a * size_a) / 2);
    slope[n] = factor * (size_a - size_b);
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
