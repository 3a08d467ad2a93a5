#pragma once

#include "solver/executors/floats.h"
#include "solver/schemes/kernels.h"
#include "solver/transfers/rounding.h"

/// Laws know doubles alone: what particles carry for them in floats is widened before and narrowed after them.
/// That costs a few conversions of numbers that are in the first-level cache, and keeps laws that iterate, and
/// small strains of large stretches, as exact as ever.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Number, int Axes>
struct NarrowParticles {
  static TransferScratch<Number>& scratch(const Block& block) {
    return static_cast<TransferScratch<Number>&>(*block.scratch);
  }
  static void widen_state(Block& block) {
    std::size_t k = 0;
    for (Attribute a : block.body->narrow_state) {
      const Number* from = block.component<Number>(a);
      double* to = scratch(block).state[k++].data();
      const double rest = value_at_rest(a);
      for (int i = 0; i < block.count; ++i) to[i] = rest + static_cast<double>(from[i]);
      block.arrays[static_cast<std::size_t>(a)] = to;
    }
  }
  static void narrow_state(Block& block) {
    for (Attribute a : block.body->narrow_state) {
      const double* from = block[a];
      Number* to = block.component<Number>(a);
      const double rest = value_at_rest(a);
      const Rounding rounded(block, a);
      for (int i = 0; i < block.count; ++i) to[i] = rounded(from[i] - rest, i);
    }
  }
  static void widen_gradient(Block& block) {
    for (int k = 0; k < Axes * Axes; ++k) {
      const Number* from = scratch(block).narrow_gradient[k].data();
      double* to = scratch(block).gradient[k].data();
      for (int i = 0; i < block.count; ++i) to[i] = static_cast<double>(from[i]);
    }
  }
  static void narrow_force(Block& block) {
    for (int k = 0; k < Axes * Axes; ++k) {
      const double* from = scratch(block).force[k].data();
      Number* to = scratch(block).narrow_force[k].data();
      for (int i = 0; i < block.count; ++i) to[i] = static_cast<Number>(from[i]);
    }
  }
};

/// Nothing where particles have doubles.
template <class Number, int Axes>
constexpr LawExchangeKernels law_exchange() {
  using Particles = NarrowParticles<Number, Axes>;
  if constexpr (std::is_same_v<Number, double>)
    return {};
  else
    return {&Particles::widen_state, &Particles::widen_gradient, &Particles::narrow_state,
            &Particles::narrow_force};
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
