#pragma once

#include "solver/transfers/scatter_rows.h"

/// Particles to grid, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A row's momentum of a particle that has the same velocity everywhere. `m`: weights times mass.
template <class Row>
struct UniformVelocity {
  __attribute__((always_inline)) UniformVelocity(const Block& of, int particle) : block(of), i(particle) {}
  __attribute__((always_inline)) Row add_momentum(int axis, int, Row m, const Row*, Row sum) const {
    return multiply_add(m, spread<Row>(component_of(block, Attribute::velocity_x, axis)[i]), sum);
  }
  const Block& block;
  int i;
};
/// The same of another vector.
template <class Row>
struct UniformVector {
  __attribute__((always_inline)) UniformVector(const RealArray* of, int particle) : values(of), i(particle) {}
  __attribute__((always_inline)) Row add_momentum(int axis, int, Row m, const Row*, Row sum) const {
    return multiply_add(m, spread<Row>(values[axis].values[i]), sum);
  }
  const RealArray* values;
  int i;
};

/// Mass, momentum and internal force. Slopes are those of the shape functions, then what the velocity needs.
template <class Stencil, Layout L, class Velocity = UniformVelocity<typename Stencil::Row>>
inline void scatter_state(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const RealArray* force = s.force_on_nodes();
  s.trouble.runs += s.runs;
  scatter_rows<Stencil, quantities(2, D)>(
      block,
      [&](int i) __attribute__((always_inline)) {
        return [&, i, velocity = Velocity(block, i) ](int row, Row w, const Row* slope, Row* sums)
            __attribute__((always_inline)) {
          const Row m = w * Real(block.mass(i));
          sums[quantity_mass] += m;
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) {
            Row& momentum = sums[quantity(sum_momentum, a, D)];
            momentum = velocity.add_momentum(a, row, m, slope + D, momentum);
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
        return [&, i ](int, Row w, const Row*, Row* sums) __attribute__((always_inline)) {
          *sums += w * Real(block.mass(i));
        };
      });
}

/// A vector times mass: Velocity(of, i).add_momentum(axis, row, weights times mass, slopes, sum) gives the sum
/// with what particle i adds.
template <class Stencil, Layout L, class Velocity, class Of>
__attribute__((always_inline)) inline void scatter_products(Block& block, SumVector vector, const Of& of) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  scatter<Stencil, L, D>(
      block, quantity(vector, 0, D), [&](int i) __attribute__((always_inline)) {
        return [&, i, velocity = Velocity(of, i) ](int row, Row w, const Row* slopes, Row* sums)
            __attribute__((always_inline)) {
          const Row m = w * Real(block.mass(i));
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) sums[a] = velocity.add_momentum(a, row, m, slopes, sums[a]);
        };
      });
}

/// A vector that particles of mass m have, times m.
template <class Stencil, Layout L>
inline void scatter_vector(Block& block, SumVector vector, const RealArray* values) {
  scatter_products<Stencil, L, UniformVector<typename Stencil::Row>>(block, vector, values);
}

/// Momentum alone, for the second mapping of MUSL.
template <class Stencil, Layout L, class Velocity = UniformVelocity<typename Stencil::Row>>
inline void scatter_momentum(Block& block) {
  scatter_products<Stencil, L, Velocity>(block, sum_momentum, block);
}

/// Loads on the particles' mass.
template <class Stencil, Layout L>
inline void scatter_loads(Block& block) {
  scatter_vector<Stencil, L>(block, sum_load, scratch_of(block).load);
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
        return [force](int, Row w, const Row*, Row* sums) __attribute__((always_inline)) { *sums -= w * force; };
      });
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
