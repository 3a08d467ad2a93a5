#pragma once

#include "solver/transfers/lanes.h"
#include "solver/transfers/strips.h"

/// Grid to particles in strips.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// What becomes of a vector that the nodes hold: put(i, axis, sums) gets a component at particle i, sums[0], and
/// its derivatives per cell, sums[1 + axis].
template <class Put>
struct Gathered {
  NodeVector vector;
  Put put;
};
template <class Put>
Gathered(NodeVector, Put) -> Gathered<Put>;

/// What a strip's cells have as a node, each of its own.
struct NodesOfCells {
  __attribute__((always_inline)) Cells operator[](int node) const { return load<Cells>(window + node); }
  const Real* window;
};

template <class OneStrip, class Stencil, Layout L, class... Put>
__attribute__((always_inline)) inline void gather_each(const RealScratch& s, const Gathered<Put>&... gathered) {
  const auto& list = OneStrip::list(s);
  for (int i = 0; i < list.size; ++i) {
    const OneStrip strip(s, i);
    const typename LanesOf<Stencil>::Type particles(s, strip);
    const NodesOfCells nodes{s.window.data() + strip.cell()};
    const auto gather_one = [&](const auto& one) __attribute__((always_inline)) {
#pragma GCC unroll 2
      for (int a = 0; a < 2; ++a) {
        Cells sums[3];
        particles.contract(nodes, quantity(one.vector, a, 2) * L.window_nodes, sums);
        for (Cells& sum : sums) sum = strip.in_order(sum);
        one.put(strip.first(), a, sums);
      }
    };
    (gather_one(gathered), ...);
  }
}

template <class Stencil, Layout L, class... Put>
__attribute__((always_inline)) inline void gather_strips(const RealScratch& s, const Gathered<Put>&... gathered) {
  // In this order: sparse strips have lanes for more than their own particles.
  gather_each<SparseStrip, Stencil, L>(s, gathered...);
  gather_each<FullStrip, Stencil, L>(s, gathered...);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
