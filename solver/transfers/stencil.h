#pragma once

#include "solver/transfers/wide_stencil.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Two nodes along each axis: all corners of a cell are one row.
template <Layout L, class... Slopes>
struct ProductStencil<2, L, Slopes...> {
  static constexpr int D = L.dimensions, nodes = 2, kinds = sizeof...(Slopes), rows = 1, together = 1;
  using Row = std::conditional_t<D == 1, Pair, std::conditional_t<D == 2, Four, Eight>>;

  __attribute__((always_inline)) ProductStencil(const RealScratch& s, RowParticles<1> of) {
    const int i = of.first;
#pragma GCC unroll 3
    for (int axis = 0; axis < D; ++axis) {
      const Row place = spread<Row>(s.place[axis].values[i]);
      factor_[axis] = multiply_add(along(axis, -1, 1), place, along(axis, 1, 0));
      int kind = 0;
      ((slope_[kind++][axis] = slope_along<Slopes>(s, axis, i)), ...);
    }
  }

  static constexpr int offset(int lane) {
    int sum = 0;
    for (int axis = 0; axis < D; ++axis) sum += (lane >> axis & 1) * L.window_stride(axis);
    return sum;
  }
  __attribute__((always_inline)) static void add_row(double* to, Row row) {
    const auto sums = converted<double>(row);
    using Side = VectorOf<double, 2>::Type;
#pragma GCC unroll 4
    for (int lane = 0; lane < 1 << D; lane += 2) add(to + offset(lane), Side{sums[lane], sums[lane + 1]});
  }

  template <class Function>
  __attribute__((always_inline)) void for_each_row(RowParticles<1>, Function&& of) const {
    Row slopes[D * kinds];
#pragma GCC unroll 2
    for (int kind = 0; kind < kinds; ++kind) {
      Row* const out = slopes + D * kind;
      if constexpr (D == 1) {
        out[0] = slope_[kind][0];
      } else if constexpr (D == 2) {
        out[0] = slope_[kind][0] * factor_[1];
        out[1] = factor_[0] * slope_[kind][1];
      } else {
        out[0] = slope_[kind][0] * (factor_[1] * factor_[2]);
        out[1] = slope_[kind][1] * (factor_[0] * factor_[2]);
        out[2] = slope_[kind][2] * (factor_[0] * factor_[1]);
      }
    }
    Row weight = factor_[0];
    for (int axis = 1; axis < D; ++axis) weight *= factor_[axis];
    of(0, weight, slopes);
  }

 private:
  /// One value for the lower corners along an axis, one for the upper ones.
  __attribute__((always_inline)) static Row along(int axis, Real lower, Real upper) {
    Real row[1 << D];
#pragma GCC unroll 8
    for (int lane = 0; lane < 1 << D; ++lane) row[lane] = lane >> axis & 1 ? upper : lower;
    return load<Row>(row);
  }
  template <class Kind>
  __attribute__((always_inline)) static Row slope_along(const RealScratch& s, int axis, int i) {
    if constexpr (std::is_same_v<Kind, ShapeSlopes>)
      return along(axis, -1, 1);
    else
      return along(axis, Kind::along(s, axis)[0].values[i], Kind::along(s, axis)[1].values[i]);
  }

  Row factor_[D], slope_[kinds][D];
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
