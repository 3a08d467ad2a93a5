#pragma once

#include <type_traits>

#include "solver/transfers/row_particles.h"
#include "solver/transfers/slopes.h"
#include "solver/transfers/vectors.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The shape functions of particles that are products along the axes, a row of nodes along x at a time.
/// Three nodes are a row of four whose last one has no weight. Slopes may be of several kinds. Two particles in
/// floats are as wide as one in doubles: in space by quadratic B-splines 118 -> 104 ns per particle and step.
template <int Nodes, Layout L, class... Slopes>
struct ProductStencil {
  static constexpr int D = L.dimensions, nodes = Nodes, kinds = sizeof...(Slopes),
                       rows = D < 2   ? 1
                              : D < 3 ? Nodes
                                      : Nodes * Nodes;
  static constexpr int together = std::is_same_v<Real, float> ? 2 : 1;
  using Row = std::conditional_t<together == 1, Four, Eight>;

  template <class Particles>
  __attribute__((always_inline)) ProductStencil(const RealScratch& s, Particles of)
      : scratch_(s),
        weight_x_(of.template row<Row>(s.weight[0], Nodes)),
        slope_x_{of.template row<Row>(Slopes::along(s, 0), Nodes)...} {}

  /// Which node of its row a lane is.
  static constexpr int offset(int lane) { return lane / together; }
  __attribute__((always_inline)) static void add_row(double* to, Row row) {
    add(to, RowParticles<together>::sum(row));
  }

  /// Calls of(index of the row's first node from the stencil's first one, weights, slopes[D] of each kind) for the
  /// same particles.
  template <class Particles, class Function>
  __attribute__((always_inline)) void for_each_row(Particles particles, Function&& of) const {
    const auto factor = [particles](const RealArray& values) __attribute__((always_inline)) {
      return particles.template factor<Row>(values.values);
    };
    using Factor = decltype(factor(scratch_.weight[0][0]));
    Row slopes[D * kinds];
    if constexpr (D == 1) {
      of(0, weight_x_, slope_x_);
    } else if constexpr (D == 2) {
#pragma GCC unroll 4
      for (int j = 0; j < Nodes; ++j) {
        const Factor w = factor(scratch_.weight[1][j]);
        const Factor slope[] = {factor(Slopes::along(scratch_, 1)[j])...};
#pragma GCC unroll 2
        for (int kind = 0; kind < kinds; ++kind) {
          slopes[D * kind] = slope_x_[kind] * w;
          slopes[D * kind + 1] = weight_x_ * slope[kind];
        }
        of(j * L.window_stride(1), weight_x_ * w, slopes);
      }
    } else {
#pragma GCC unroll 4
      for (int k = 0; k < Nodes; ++k) {
        const Factor wz = factor(scratch_.weight[2][k]);
        const Row weight_xz = weight_x_ * wz;
        Row slope_xz[2 * kinds];
        const Factor slope_z[] = {factor(Slopes::along(scratch_, 2)[k])...};
#pragma GCC unroll 2
        for (int kind = 0; kind < kinds; ++kind) {
          slope_xz[2 * kind] = slope_x_[kind] * wz;
          slope_xz[2 * kind + 1] = weight_x_ * slope_z[kind];
        }
#pragma GCC unroll 4
        for (int j = 0; j < Nodes; ++j) {
          const Factor wy = factor(scratch_.weight[1][j]);
          const Factor slope_y[] = {factor(Slopes::along(scratch_, 1)[j])...};
#pragma GCC unroll 2
          for (int kind = 0; kind < kinds; ++kind) {
            slopes[D * kind] = slope_xz[2 * kind] * wy;
            slopes[D * kind + 1] = weight_xz * slope_y[kind];
            slopes[D * kind + 2] = slope_xz[2 * kind + 1] * wy;
          }
          of(j * L.window_stride(1) + k * L.window_stride(2), weight_xz * wy, slopes);
        }
      }
    }
  }

 private:
  const RealScratch& scratch_;
  Row weight_x_, slope_x_[kinds];
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
