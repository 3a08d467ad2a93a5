#pragma once

#include "solver/transfers/real.h"
#include "solver/transfers/vectors.h"

/// What particles that do not turn give to momenta.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Particles that have the same velocity everywhere.
struct UniformVelocity {
  template <class Strips>
  __attribute__((always_inline)) static auto given(const Strips& strips, double* to, const Block& block,
                                                   int axis) {
    return strips.momentum(to, component_of(block, Attribute::velocity_x, axis));
  }
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
  template <class Strips>
  __attribute__((always_inline)) static auto given(const Strips& strips, double* to, const RealArray* of,
                                                   int axis) {
    return strips.momentum(to, of[axis].values);
  }
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

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
