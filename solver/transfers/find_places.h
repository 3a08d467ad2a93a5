#pragma once

#include <cstdint>
#include <type_traits>

#include "solver/transfers/find_fixed_places.h"

/// Where particles are: the first node of each one's stencil, and its place in it.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Places in doubles, whether or not axes are periodic. Returns whether one is out of where its tile allows.
template <class Shape, Layout L>
inline bool find_places_in_doubles(Block& block) {
  RealScratch& s = scratch_of(block);
  const int count = block.count;
  AxisPlaces axes[L.dimensions];
  bool any_period = false;
  for (int a = 0; a < L.dimensions; ++a) {
    axes[a] = axis_places<L>(block, a);
    any_period = any_period || axes[a].period > 0;
  }
  constexpr double below = 1 - 0x1p-40;
  const double inverse_cell = block.sweep->inverse_cell;
  // As wide as what is compared.
  std::int64_t out = 0;
  const auto find_each = [&](auto in_window) __attribute__((always_inline)) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
      double cell = 0;
#pragma GCC unroll 3
      for (int a = 0; a < L.dimensions; ++a) {
        const AxisPlaces& axis = axes[a];
        const double highest = axis.highest + below;
        const double at = in_window((axis.x[i] - axis.origin) * inverse_cell - axis.first, axis);
        const double not_below = at > axis.lowest ? at : axis.lowest;
        const double inside = not_below < highest ? not_below : highest;
        out |= inside != at;
        const double base = Shape::first_node(inside);
        axis.place[i] = Real(inside - base);
        cell += base * L.window_stride(a);
      }
      s.cell[i] = static_cast<int>(cell);
    }
  };
  if (any_period)
    find_each([](double at, const AxisPlaces& axis) {
      return at - axis.period * __builtin_floor((at - axis.lowest) / axis.divisor);
    });
  else
    find_each([](double at, const AxisPlaces&) { return at; });
  return out != 0;
}

/// The first node of each particle's stencil and its place in the stencil. A particle that is not where its tile
/// allows is put to the nearest place that is, so that what follows is harmless, and that there is one is noted.
template <class Shape, Layout L>
inline void find_places(Block& block) {
  bool any_period = false;
  for (int axis = 0; axis < L.dimensions; ++axis) any_period = any_period || block.sweep->period[axis] > 0;
  const bool left = std::is_same_v<Real, float> && !any_period ? find_places_in_fixed_point<Shape, L>(block)
                                                               : find_places_in_doubles<Shape, L>(block);
  scratch_of(block).trouble.left_window |= left;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
