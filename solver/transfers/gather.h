#pragma once

#include "solver/transfers/lanes.h"
#include "solver/transfers/runs.h"
#include "solver/transfers/strip_gather.h"

/// Grid to particles, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Of so many runs from one on, or of that one alone if all together have more particles than there are lanes,
/// across particles, so that nodes are read once for all of them and no vector's parts are to be added up. Returns
/// how many runs that were.
template <class Stencil, Layout L, int Runs, class... Put>
__attribute__((always_inline)) inline int gather_runs(const RealScratch& s, int run,
                                                      const Gathered<Put>&... gathered) {
  constexpr int D = L.dimensions;
  using Particles = typename LanesOf<Stencil>::Type;
  using Lanes = typename Particles::Lanes;
  const int begin = s.run_begin[run], end = s.run_begin[run + Runs < s.runs ? run + Runs : s.runs];
  if constexpr (Runs > 1)
    if (end - begin > Particles::lanes) return gather_runs<Stencil, L, 1>(s, run, gathered...);
  const NodesOfRuns<Lanes, Runs> nodes(s, run, s.window.data());
  for (int i = begin; i < end; i += Particles::lanes) {
    const Particles particles(s, Consecutive<Lanes>{i});
    const auto gather_one = [&](const auto& one) __attribute__((always_inline)) {
#pragma GCC unroll 3
      for (int a = 0; a < D; ++a) {
        Lanes sums[1 + D];
        particles.contract(nodes, quantity(one.vector, a, D) * L.window_nodes, sums);
        one.put(i, a, sums);
      }
    };
    (gather_one(gathered), ...);
  }
  return Runs;
}

/// Vectors at the particles. Where shape functions are products that is for several particles at once, some of
/// them past the last one.
template <class Stencil, Layout L, class... Put>
__attribute__((always_inline)) inline void gather(Block& block, const Gathered<Put>&... gathered) {
  constexpr int D = L.dimensions;
  const RealScratch& s = scratch_of(block);
  if constexpr (LanesOf<Stencil>::exist) {
    // As many as there are lanes for, with two particles to a cell's side.
    constexpr int room = LanesOf<Stencil>::Type::lanes >> (D < 2 ? 2 : D), runs = room > 1 ? room : 1;
    if constexpr (has_strips<Stencil>)
      if (s.by_strips) return gather_strips<Stencil, L>(s, gathered...);
    know_runs(block);
    for (int run = 0; run < s.runs;) run += gather_runs<Stencil, L, runs>(s, run, gathered...);
  } else {
    using Row = typename Stencil::Row;
    const auto gather_one = [&](const auto& one) __attribute__((always_inline)) {
      const Real* window = s.window.data() + L.window_array(quantity(one.vector, 0, D));
      for (int i = 0; i < block.count; ++i) {
        Row sums[D][1 + D] = {};
        const auto add_row = [&](int at, Row w, const Row* slope) __attribute__((always_inline)) {
          for (int a = 0; a < D; ++a) {
            const Row value = load<Row>(window + L.window_array(a) + s.cell[i] + at);
            sums[a][0] += w * value;
            for (int b = 0; b < D; ++b) sums[a][1 + b] += slope[b] * value;
          }
        };
        const RowParticles<1> particle{i};
        Stencil(s, particle).for_each_row(particle, add_row);
        for (int a = 0; a < D; ++a) {
          Real of_particle[1 + D];
          for (int b = 0; b <= D; ++b) of_particle[b] = sum(sums[a][b]);
          one.put(i, a, of_particle);
        }
      }
    };
    (gather_one(gathered), ...);
  }
}

/// For Gathered: keeps the vector itself.
__attribute__((always_inline)) inline auto keep_in(RealArray* out) {
  return [out](int i, int a, const auto& sums) __attribute__((always_inline)) {
    store(out[a].values + i, sums[0]);
  };
}

/// For Gathered: keeps its gradient.
template <int D>
__attribute__((always_inline)) inline auto keep_gradient(const Block& block) {
  return [ gradient = scratch_of(block).gradient_of_grid(), per_cell = Real(block.sweep->inverse_cell) ](
      int i, int a, const auto& sums) __attribute__((always_inline)) {
    for (int b = 0; b < D; ++b) store(gradient[a * D + b].values + i, per_cell * sums[1 + b]);
  };
}

template <class Stencil, Layout L>
inline void gather_acceleration(Block& block) {
  gather<Stencil, L>(block, Gathered{node_acceleration, keep_in(scratch_of(block).acceleration)});
}

template <class Stencil, Layout L>
inline void gather_velocity(Block& block) {
  gather<Stencil, L>(block, Gathered{node_velocity, keep_in(scratch_of(block).velocity)});
}

/// Gradient of the velocity that is for gradients.
template <class Stencil, Layout L>
inline void gather_gradient(Block& block) {
  gather<Stencil, L>(block, Gathered{node_mapped_velocity, keep_gradient<L.dimensions>(block)});
}

/// Velocity of the grid, and gradient of the one that is for gradients.
template <class Stencil, Layout L>
inline void gather_motion(Block& block) {
  if constexpr (L.dimensions < 3) {
    gather<Stencil, L>(block, Gathered{node_velocity, keep_in(scratch_of(block).velocity)},
                       Gathered{node_mapped_velocity, keep_gradient<L.dimensions>(block)});
  } else {
    // There are not enough registers for both.
    gather_velocity<Stencil, L>(block);
    gather_gradient<Stencil, L>(block);
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
