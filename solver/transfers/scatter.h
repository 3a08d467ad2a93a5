#pragma once

#include "solver/transfers/scatter_rows.h"
#include "solver/transfers/uniform_velocity.h"

/// Particles to grid, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Mass, momentum and internal force. Slopes are those of the shape functions, then what the velocity needs.
template <class Stencil, Layout L, class Velocity = UniformVelocity>
inline void scatter_state(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const RealArray* force = s.force_on_nodes();
  s.trouble.runs += s.by_strips ? s.full_strips.size + s.sparse_strips.size : s.runs;
  double* const to = block.sums;
  scatter_rows<Stencil, L, quantities(2, D)>(
      block,
      [&](auto particles) __attribute__((always_inline)) {
        using VelocityOf = typename Velocity::template Of<Row, decltype(particles)>;
        return [&, particles, velocity = VelocityOf{block, particles} ](int row, Row w, const Row* slope,
                                                                        Row* sums) __attribute__((always_inline)) {
          const Row m = w * masses<Row>(block, particles);
          sums[quantity_mass] += m;
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) {
            Row& momentum = sums[quantity(sum_momentum, a, D)];
            momentum = velocity.add_momentum(a, row, m, slope + D, momentum);
            Row& resistance = sums[quantity(sum_force, a, D)];
#pragma GCC unroll 3
            for (int b = 0; b < D; ++b)
              resistance =
                  multiply_add(slope[b], particles.template each<Row>(force[a * D + b].values), resistance);
          }
        };
      },
      [=](int q, std::int64_t at, Row row) __attribute__((always_inline)) {
        Stencil::add_row(to + L.window_array(q) + at, q < quantity(sum_force, 0, D) ? row : -row);
      },
      [&](const auto& strips) __attribute__((always_inline)) {
        if constexpr (has_strips<Stencil>) {
          const auto momentum = [&](int a) __attribute__((always_inline)) {
            return Velocity::given(strips, to + L.window_array(quantity(sum_momentum, a, D)), block, a);
          };
          const auto resistance = [&](int a) __attribute__((always_inline)) {
            return strips.force(to + L.window_array(quantity(sum_force, a, D)), force[D * a].values,
                                force[D * a + 1].values);
          };
          strips.give(strips.mass(to), momentum(0), momentum(1), resistance(0), resistance(1));
        }
      });
}

template <class Stencil, Layout L>
inline void scatter_mass(Block& block) {
  using Row = typename Stencil::Row;
  scatter<Stencil, L, 1>(
      block, quantity_mass,
      [&](auto particles) __attribute__((always_inline)) {
        return [&, particles ](int, Row w, const Row*, Row* sums) __attribute__((always_inline)) {
          *sums += w * masses<Row>(block, particles);
        };
      },
      [&](const auto& strips) __attribute__((always_inline)) { strips.give(strips.mass(block.sums)); });
}

/// A vector times mass: Velocity::Of<Row, Particles>{of, particles}.add_momentum(axis, row, weights times
/// mass, slopes, sum) gives the sum with what these add.
template <class Stencil, Layout L, class Velocity, class Of>
__attribute__((always_inline)) inline void scatter_products(Block& block, SumVector vector, const Of& of) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  scatter<Stencil, L, D>(
      block, quantity(vector, 0, D),
      [&](auto particles) __attribute__((always_inline)) {
        using VelocityOf = typename Velocity::template Of<Row, decltype(particles)>;
        return [&, particles, velocity = VelocityOf{of, particles} ](int row, Row w, const Row* slopes, Row* sums)
            __attribute__((always_inline)) {
          const Row m = w * masses<Row>(block, particles);
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) sums[a] = velocity.add_momentum(a, row, m, slopes, sums[a]);
        };
      },
      [&](const auto& strips) __attribute__((always_inline)) {
        if constexpr (has_strips<Stencil>) {
          const auto given = [&](int a) __attribute__((always_inline)) {
            return Velocity::given(strips, block.sums + L.window_array(quantity(vector, a, D)), of, a);
          };
          strips.give(given(0), given(1));
        }
      });
}

/// A vector that particles of mass m have, times m.
template <class Stencil, Layout L>
inline void scatter_vector(Block& block, SumVector vector, const RealArray* values) {
  scatter_products<Stencil, L, UniformVector>(block, vector, values);
}

/// Momentum alone, for the second mapping of MUSL.
template <class Stencil, Layout L, class Velocity = UniformVelocity>
inline void scatter_momentum(Block& block) {
  scatter_products<Stencil, L, Velocity>(block, sum_momentum, block);
}

/// Loads on the particles' mass.
template <class Stencil, Layout L>
inline void scatter_loads(Block& block) {
  scatter_vector<Stencil, L>(block, sum_load, scratch_of(block).load);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
