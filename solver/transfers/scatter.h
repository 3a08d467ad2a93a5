#pragma once

#include "solver/transfers/scatter_rows.h"

/// Particles to grid, with any shape functions.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Particles that have the same velocity everywhere.
struct UniformVelocity {
  /// A row's momentum. `m`: weights times mass.
  template <class Row, class Particles>
  struct Of {
    __attribute__((always_inline)) Row add_momentum(int axis, int, Row m, const Row*, Row sum) const {
      return multiply_add(m, particles.template each<Row>(component_of(block, Attribute::velocity_x, axis)), sum);
    }
    const Block& block;
    Particles particles;
  };
};
/// The same of another vector.
struct UniformVector {
  template <class Row, class Particles>
  struct Of {
    __attribute__((always_inline)) Row add_momentum(int axis, int, Row m, const Row*, Row sum) const {
      return multiply_add(m, particles.template each<Row>(values[axis].values), sum);
    }
    const RealArray* values;
    Particles particles;
  };
};

/// Masses of particles, as a factor of a row.
template <class Row, class Particles>
__attribute__((always_inline)) inline auto masses(const Block& block, Particles particles) {
  return particles.template factor<Row>([&block](int i)
                                            __attribute__((always_inline)) { return Real(block.mass(i)); });
}

/// Mass, momentum and internal force. Slopes are those of the shape functions, then what the velocity needs.
template <class Stencil, Layout L, class Velocity = UniformVelocity>
inline void scatter_state(Block& block) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const RealArray* force = s.force_on_nodes();
  s.trouble.runs += s.runs;
  scatter_rows<Stencil, quantities(2, D)>(
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
      [sums = block.sums](int q, std::int64_t at, Row row) __attribute__((always_inline)) {
        Stencil::add_row(sums + L.window_array(q) + at, q < quantity(sum_force, 0, D) ? row : -row);
      });
}

template <class Stencil, Layout L>
inline void scatter_mass(Block& block) {
  using Row = typename Stencil::Row;
  scatter<Stencil, L, 1>(
      block, quantity_mass, [&](auto particles) __attribute__((always_inline)) {
        return [&, particles ](int, Row w, const Row*, Row* sums) __attribute__((always_inline)) {
          *sums += w * masses<Row>(block, particles);
        };
      });
}

/// A vector times mass: Velocity::Of<Row, Particles>{of, particles}.add_momentum(axis, row, weights times
/// mass, slopes, sum) gives the sum with what these add.
template <class Stencil, Layout L, class Velocity, class Of>
__attribute__((always_inline)) inline void scatter_products(Block& block, SumVector vector, const Of& of) {
  constexpr int D = L.dimensions;
  using Row = typename Stencil::Row;
  scatter<Stencil, L, D>(
      block, quantity(vector, 0, D), [&](auto particles) __attribute__((always_inline)) {
        using VelocityOf = typename Velocity::template Of<Row, decltype(particles)>;
        return [&, particles, velocity = VelocityOf{of, particles} ](int row, Row w, const Row* slopes, Row* sums)
            __attribute__((always_inline)) {
          const Row m = w * masses<Row>(block, particles);
#pragma GCC unroll 3
          for (int a = 0; a < D; ++a) sums[a] = velocity.add_momentum(a, row, m, slopes, sums[a]);
        };
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

/// Axisymmetric: the hoop stress pulls towards the axis, with volume times stress over radius per radian
/// (Sulsky and Schreyer 1996).
template <class Stencil, Layout L>
inline void scatter_hoop(Block& block) {
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const double* radius = block[Attribute::position_x];
  scatter<Stencil, L, 1>(
      block, quantity(sum_force, 0, L.dimensions), [&](auto particles) __attribute__((always_inline)) {
        const auto force = particles.template factor<Row>([&](int i) __attribute__((always_inline)) {
          return Real(s.virial_rest[i] / radius[i]);
        });
        return [force](int, Row w, const Row*, Row* sums) __attribute__((always_inline)) { *sums -= w * force; };
      });
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
