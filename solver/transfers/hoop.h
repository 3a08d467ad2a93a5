#pragma once

#include "solver/transfers/gather.h"
#include "solver/transfers/scatter.h"

/// What axisymmetric bodies have around the axis.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The hoop stress pulls towards the axis, with volume times stress over radius per radian
/// (Sulsky and Schreyer 1996).
template <class Stencil, Layout L>
inline void scatter_hoop(Block& block) {
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  const double* radius = block[Attribute::position_x];
  // Nothing else needs accelerations before nodes have them.
  Real* const pull = s.acceleration[0].values;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) pull[i] = Real(-s.virial_rest[i] / radius[i]);
  const int which = quantity(sum_force, 0, L.dimensions);
  scatter<Stencil, L, 1>(
      block, which,
      [&](auto particles) __attribute__((always_inline)) {
        return [pull = particles.template factor<Row>(pull)](int, Row w, const Row*, Row* sums)
            __attribute__((always_inline)) {
          *sums += w * pull;
        };
      },
      [&](const auto& strips) __attribute__((always_inline)) {
        strips.give(strips.weighed(block.sums + L.window_array(which), pull));
      });
}

/// Hoop strain rate of the velocity that is for gradients.
template <class Stencil, Layout L>
inline void gather_hoop(Block& block) {
  BlockDoubles& hoop = block.scratch->gradient_rest;
  const double* radius = block[Attribute::position_x];
  const auto keep = [&](int i, int a, const auto& sums) __attribute__((always_inline)) {
    if (a == 0) store(hoop.values + i, sums[0]);
  };
  gather<Stencil, L>(block, Gathered{node_mapped_velocity, keep});
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) hoop[i] /= radius[i];
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
