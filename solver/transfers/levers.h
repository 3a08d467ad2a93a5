#pragma once

#include <limits>

#include "solver/transfers/locate.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Levers add up to zero and, times the distances of the nodes, to one. So do slopes, which they become where a
/// particle has all its weight on one node; by linear functions and Bernstein polynomials they are the same
/// everywhere. What rounding has left of the first sum goes to the nodes by their weights, lest a small D make
/// momentum of it.
template <int Nodes, int D>
inline void find_levers_by_weights(Block& block) {
  RealScratch& s = scratch_of(block);
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    Real lever[D][Nodes], divisor[D], product = 1;
    bool some[D];
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      Real inertia = 0;
#pragma GCC unroll 4
      for (int n = 0; n < Nodes; ++n) {
        const Real distance = Real(n) - s.place[a][i];
        lever[a][n] = s.weight[a][n][i] * distance;
        inertia += lever[a][n] * distance;
      }
      s.levers[a].inertia[i] = inertia;
      // Some thousand roundings of the weights.
      some[a] = inertia > 4500 * std::numeric_limits<Real>::epsilon();
      divisor[a] = some[a] ? inertia : 1;
      product *= divisor[a];
    }
    // One division for all axes, which take as long as all else here.
    const Real inverse = 1 / product;
#pragma GCC unroll 3
    for (int a = 0; a < D; ++a) {
      Real factor = inverse, sum = 0;
#pragma GCC unroll 3
      for (int other = 0; other < D; ++other)
        if (other != a) factor *= divisor[other];
#pragma GCC unroll 4
      for (int n = 0; n < Nodes; ++n) {
        lever[a][n] = some[a] ? lever[a][n] * factor : s.slope[a][n][i];
        sum += lever[a][n];
      }
#pragma GCC unroll 4
      for (int n = 0; n < Nodes; ++n) s.levers[a].lever[n][i] = lever[a][n] - sum * s.weight[a][n][i];
    }
  }
}

template <class Shape, int D>
inline void find_levers(Block& block) {
  if constexpr (Shape::nodes == 2)
    for (int axis = 0; axis < D; ++axis) weigh_along<Shape>(block, axis);
  find_levers_by_weights<Shape::nodes, D>(block);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
