#pragma once

#include "solver/transfers/runs.h"
#include "solver/transfers/stencil.h"

/// Particles to grid, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Adds what particles give to their nodes. give(i) is a function that adds what particle i gives to a row of
/// nodes, of (weights, slopes[D], sums of the row). The sums of a run stay in registers until the nodes change;
/// then add(which, index of the row's first node, sum) is called for each.
template <class Stencil, int Sums, class Give, class Add>
__attribute__((always_inline)) inline void scatter_rows(Block& block, Give&& give, Add&& add_sum) {
  using Row = typename Stencil::Row;
  const RealScratch& s = scratch_of(block);
  for_each_run(
      block, [&](int begin, int end, std::int64_t node) __attribute__((always_inline)) {
        Row of_run[Stencil::rows][Sums] = {};
        for (int i = begin; i < end; ++i) {
          const auto give_row = give(i);
          int row = 0;
          Stencil(s, i).for_each_row([&](int, Row w, const Row* slopes)
                                         __attribute__((always_inline)) { give_row(w, slopes, of_run[row++]); });
        }
        int row = 0;
        Stencil(s, begin).for_each_row([&](int at, Row, const Row*) __attribute__((always_inline)) {
#pragma GCC unroll 7
          for (int sum = 0; sum < Sums; ++sum) add_sum(sum, node + at, of_run[row][sum]);
          ++row;
        });
      });
}

/// The same with one sum for each quantity, so many from `first` on.
template <class Stencil, Layout L, int Quantities, class Give>
__attribute__((always_inline)) inline void scatter(Block& block, int first, Give&& give) {
  double* sums = block.sums + first * L.window_nodes;
  scatter_rows<Stencil, Quantities>(
      block, give, [=](int q, std::int64_t at, auto row) __attribute__((always_inline)) {
        Stencil::add_row(sums + q * L.window_nodes + at, row);
      });
}

/// Mass, momentum and internal force.
template <class Stencil, Layout L>
inline void scatter_state(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const RealArray* force = s.force_on_nodes();
  s.trouble.runs += Runs(block).count;
  scatter_rows<Stencil, quantities(2, D)>(
      block,
      [&](int i) __attribute__((always_inline)) {
        return [&, i ](Row w, const Row* slope, Row* sums) __attribute__((always_inline)) {
          const Row m = w * Real(block.mass(i));
          sums[quantity_mass] += m;
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) {
            Row& momentum = sums[quantity(sum_momentum, a, D)];
            momentum = multiply_add(m, spread<Row>(component_of(block, Attribute::velocity_x, a)[i]), momentum);
            Row& resistance = sums[quantity(sum_force, a, D)];
#pragma GCC unroll 3
            for (int b = 0; b < D; ++b)
              resistance = multiply_add(slope[b], spread<Row>(force[a * D + b][i]), resistance);
          }
        };
      },
      [sums = block.sums](int q, std::int64_t at, Row row) __attribute__((always_inline)) {
        Stencil::add_row(sums + q * L.window_nodes + at, q < quantity(sum_force, 0, D) ? row : -row);
      });
}

template <class Stencil, Layout L>
inline void scatter_mass(Block& block) {
  using Row = typename Stencil::Row;
  scatter<Stencil, L, 1>(
      block, quantity_mass, [&](int i) __attribute__((always_inline)) {
        return [&, i ](Row w, const Row*, Row* sums) __attribute__((always_inline)) {
          *sums += w * Real(block.mass(i));
        };
      });
}

/// A vector that particles of mass m have, times m.
template <class Stencil, Layout L, class Value>
__attribute__((always_inline)) inline void scatter_vector(Block& block, SumVector vector, Value&& value) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  scatter<Stencil, L, D>(
      block, quantity(vector, 0, D), [&](int i) __attribute__((always_inline)) {
        return [&, i ](Row w, const Row*, Row* sums) __attribute__((always_inline)) {
          const Row m = w * Real(block.mass(i));
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) sums[a] = multiply_add(m, spread<Row>(value(a, i)), sums[a]);
        };
      });
}

/// Momentum alone, for the second mapping of MUSL.
template <class Stencil, Layout L>
inline void scatter_momentum(Block& block) {
  scatter_vector<Stencil, L>(
      block, sum_momentum, [&](int a, int i) __attribute__((always_inline)) {
        return component_of(block, Attribute::velocity_x, a)[i];
      });
}

/// Loads on the particles' mass.
template <class Stencil, Layout L>
inline void scatter_loads(Block& block) {
  scatter_vector<Stencil, L>(
      block, sum_load, [&](int a, int i) __attribute__((always_inline)) { return scratch_of(block).load[a][i]; });
}

/// Axisymmetric: the hoop stress pulls towards the axis, with volume times stress over radius per radian
/// (Sulsky and Schreyer 1996).
template <class Stencil, Layout L>
inline void scatter_hoop(Block& block) {
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const double* radius = block[Attribute::position_x];
  scatter<Stencil, L, 1>(
      block, quantity(sum_force, 0, L.dimensions), [&](int i) __attribute__((always_inline)) {
        const Real force = Real(s.virial_rest[i] / radius[i]);
        return [force](Row w, const Row*, Row* sums) __attribute__((always_inline)) { *sums -= w * force; };
      });
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
