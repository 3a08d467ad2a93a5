#pragma once

#include <cstdint>

#include "solver/executors/instruction_set.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Where something is along an axis, in whole units of 2^-bits of a cell: what is left of it as a float is exact
/// to that unit wherever in a window it is, and where it is takes half as many operations as by doubles. Floats in
/// a plane take 0.7 to 0.8 ns less per particle and step.
template <int bits>
struct FixedPlace {
  std::int32_t units;

  static constexpr double units_of_cell = std::int64_t{1} << bits;
  /// To the nearest unit.
  static constexpr FixedPlace of_cells(double cells) {
    return {static_cast<std::int32_t>(cells * units_of_cell + (cells < 0 ? -0.5 : 0.5))};
  }

  /// Far outside of windows they may wrap around.
  friend constexpr FixedPlace operator-(FixedPlace a, FixedPlace b) {
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(a.units) - static_cast<std::uint32_t>(b.units))};
  }
  /// \name What shape functions do with places, to find a first node
  /// @{
  friend constexpr FixedPlace whole_part(FixedPlace a) { return {a.units & -(std::int32_t{1} << bits)}; }
  friend constexpr FixedPlace operator-(FixedPlace a, double cells) { return a - of_cells(cells); }
  friend constexpr FixedPlace half(FixedPlace a) { return {a.units >> 1}; }
  friend constexpr FixedPlace twice(FixedPlace a) { return {a.units << 1}; }
  /// @}
  constexpr std::int32_t cell() const { return units >> bits; }
  constexpr float cells() const { return static_cast<float>(units) * static_cast<float>(1 / units_of_cell); }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
