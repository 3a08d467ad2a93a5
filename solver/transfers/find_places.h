#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "solver/transfers/fixed_place.h"
#include "solver/transfers/real.h"
#include "solver/transfers/registers.h"

/// Where particles are: the first node of each one's stencil, and its place in it.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Along one axis: what is needed to find places.
struct AxisPlaces {
  const double* x;
  Real* place;
  double origin, first;    ///< of what counts places in cells
  double lowest, highest;  ///< where the first and the last cell begin in which particles may be
  double period, divisor;
};

template <Layout L>
__attribute__((always_inline)) inline AxisPlaces axis_places(const Block& block, int axis) {
  const double to_nodes = L.below - 1, period = block.sweep->period[axis];
  return {.x = block.component(Attribute::position_x, axis),
          .place = scratch_of(block).place[axis].data(),
          .origin = block.sweep->origin[axis],
          .first = block.window_first[axis] - to_nodes,
          .lowest = block.lowest[axis] + to_nodes + begin_of_cells(L.reach),
          .highest = block.highest[axis] + to_nodes + begin_of_cells(L.reach),
          .period = period,
          .divisor = period > 0 ? period : 1};
}

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

/// The same in fixed point, where no axis is periodic. What is not even a number becomes the least integer, which
/// is out of where any tile allows.
template <class Shape, Layout L>
__attribute__((no_sanitize("float-cast-overflow"))) inline bool find_places_in_fixed_point(Block& block) {
  // With so many bits whatever is in a window has one bit to spare.
  using Fixed = FixedPlace<31 - std::bit_width(static_cast<unsigned>(L.side) + 4)>;
  RealScratch& s = scratch_of(block);
  const int count = block.count;
  struct Axis {
    AxisPlaces in;
    double scale, offset;
    std::int32_t lowest, highest;
  };
  Axis axes[L.dimensions];
  for (int a = 0; a < L.dimensions; ++a) {
    const AxisPlaces in = axis_places<L>(block, a);
    const double scale = block.sweep->inverse_cell * Fixed::units_of_cell;
    axes[a] = {in, scale, -in.origin * scale - in.first * Fixed::units_of_cell, Fixed::of_cells(in.lowest).units,
               Fixed::of_cells(in.highest + 1).units - 1};
  }
  std::uint32_t out = 0;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    std::int32_t cell = 0;
#pragma GCC unroll 3
    for (int a = 0; a < L.dimensions; ++a) {
      const Axis& axis = axes[a];
      const auto at = static_cast<std::int32_t>(multiply_add(axis.in.x[i], axis.scale, axis.offset));
      const std::int32_t not_below = at > axis.lowest ? at : axis.lowest;
      const Fixed inside{not_below < axis.highest ? not_below : axis.highest};
      // Rounding may put a place on the face to the next cell that sorting has found to be just before it.
      out |= (static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(inside.units) + 1) & ~3U;
      const Fixed base = Shape::first_node(inside);
      axis.in.place[i] = (inside - base).cells();
      cell += base.cell() * L.window_stride(a);
    }
    s.cell[i] = cell;
  }
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
