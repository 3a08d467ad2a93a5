#pragma once

#include <bit>
#include <cstdint>

#include "solver/transfers/axis_places.h"
#include "solver/transfers/fixed_place.h"
#include "solver/transfers/registers.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The first node of each particle's stencil and its place in it, in fixed point, where no axis is periodic.
/// Returns whether one is out of where its tile allows. What is not even a number becomes the least integer, which
/// is out of where any tile allows.
template <class Shape, Layout L>
inline bool find_places_in_fixed_point(Block& block) {
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
  const auto find_each = [&](auto in_window) __attribute__((always_inline, no_sanitize("float-cast-overflow"))) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
      std::int32_t cell = 0;
#pragma GCC unroll 3
      for (int a = 0; a < L.dimensions; ++a) {
        const Axis& axis = axes[a];
        const Fixed inside{
            in_window(static_cast<std::int32_t>(multiply_add(axis.in.x[i], axis.scale, axis.offset)), a)};
        const Fixed base = Shape::first_node(inside);
        axis.in.place[i] = (inside - base).cells();
        cell += base.cell() * L.window_stride(a);
      }
      s.cell[i] = cell;
    }
  };
  // How far particles are from the lowest place: those below it seem to be very far.
  std::uint32_t farthest[L.dimensions] = {};
  const auto from_lowest = [&](std::int32_t at, int a) __attribute__((always_inline)) {
    return static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(axes[a].lowest);
  };
  find_each([&](std::int32_t at, int a) __attribute__((always_inline)) {
    const std::uint32_t far = from_lowest(at, a);
    farthest[a] = far > farthest[a] ? far : farthest[a];
    return at;
  });
  bool all_inside = true;
  for (int a = 0; a < L.dimensions; ++a) all_inside = all_inside && farthest[a] <= from_lowest(axes[a].highest, a);
  if (all_inside) return false;

  // Once more, into the window: hardly ever.
  std::uint32_t out = 0;
  find_each([&](std::int32_t at, int a) __attribute__((always_inline)) {
    const std::int32_t not_below = at > axes[a].lowest ? at : axes[a].lowest;
    const std::int32_t inside = not_below < axes[a].highest ? not_below : axes[a].highest;
    // Rounding may put a place on the face to the next cell that sorting has found to be just before it.
    out |= (static_cast<std::uint32_t>(at) - static_cast<std::uint32_t>(inside) + 1) & ~3U;
    return inside;
  });
  return out != 0;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
