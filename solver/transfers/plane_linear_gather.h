#pragma once

#include "solver/executors/tiles.h"
#include "solver/transfers/plane_linear.h"

/// Grid to particles with bilinear shape functions (Sulsky, Chen and Schreyer 1994), four particles at a time.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Copies what a tile and its neighbours hold into a window, with differences along the axes. `mask`: bits of
/// the quantities.
inline void load_window_plane_linear(Scratch& scratch, const Neighbours& nodes, unsigned mask) {
  Real* window = static_cast<RealScratch&>(scratch).window.data();
  constexpr int side = plane_linear_layout.side, window_side = plane_linear_layout.window_side;
  constexpr int window_nodes = plane_linear_layout.window_nodes;
  for (int q = 0; mask >> q; ++q) {
    if (!(mask >> q & 1u)) continue;
    Real* base = window + q * PlaneLinearValue::copies * window_nodes;
    Real *dx = base + window_nodes, *dy = dx + window_nodes, *dxy = dy + window_nodes;
    for (int row = 0; row < window_side; ++row) {
      const int j = row - 1, n = j < 0 ? 0 : j < side ? 3 : 6;
      const int at = q * tile_nodes + (j & (side - 1)) * side;
      Real* out = base + row * window_side;
      out[0] = Real(nodes[n][at + side - 1]);
      for (int i = 0; i < side; ++i) out[1 + i] = Real(nodes[n + 1][at + i]);
      for (int i = 0; i < 2; ++i) out[1 + side + i] = Real(nodes[n + 2][at + i]);
    }
    // Where the last row and column have no right or upper neighbour, no cell begins.
    constexpr int cells = window_side * (window_side - 1) - 1;
    for (int k = 0; k < cells; ++k) {
      const Real right = base[k + 1] - base[k];
      dx[k] = right;
      dy[k] = base[k + window_side] - base[k];
      dxy[k] = (base[k + window_side + 1] - base[k + window_side]) - right;
    }
  }
}

/// out = value of a node quantity at the particles. Writes up to three entries too many per run, which the
/// next run overwrites.
__attribute__((always_inline)) inline void interpolate(const PlaneLinearValue& v, std::int64_t k, Four fx, Four fy,
                                                       Real* out) {
  store(out, v.base[k] + fx * v.dx[k] + fy * (v.dy[k] + fx * v.dxy[k]));
}

__attribute__((always_inline)) inline PlaneLinearValue value_of(const RealScratch& s, NodeVector vector,
                                                                int axis) {
  return {s.window.data(), quantity(vector, axis, 2)};
}

inline void gather_plane_linear(Block& block, NodeVector vector, RealArray* out) {
  RealScratch& s = scratch_of(block);
  const PlaneLinearValue vx = value_of(s, vector, 0), vy = value_of(s, vector, 1);
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        for (int i = begin; i < end; i += 4) {
          const Four fx = load<Four>(&s.place[0][i]), fy = load<Four>(&s.place[1][i]);
          interpolate(vx, k, fx, fy, &out[0][i]);
          interpolate(vy, k, fx, fy, &out[1][i]);
        }
      });
}

inline void gather_acceleration_plane_linear(Block& block) {
  gather_plane_linear(block, node_acceleration, scratch_of(block).acceleration);
}
inline void gather_velocity_plane_linear(Block& block) {
  gather_plane_linear(block, node_velocity, scratch_of(block).velocity);
}

/// Gradient of the velocity that is for gradients.
inline void gather_gradient_plane_linear(Block& block) {
  RealScratch& s = scratch_of(block);
  const PlaneLinearValue wx = value_of(s, node_mapped_velocity, 0), wy = value_of(s, node_mapped_velocity, 1);
  const Real q = Real(block.sweep->inverse_cell);
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        const Real xx = q * wx.dx[k], xy = q * wx.dy[k], xxy = q * wx.dxy[k];
        const Real yx = q * wy.dx[k], yy = q * wy.dy[k], yxy = q * wy.dxy[k];
        for (int i = begin; i < end; i += 4) {
          const Four fx = load<Four>(&s.place[0][i]), fy = load<Four>(&s.place[1][i]);
          store(&s.gradient[0][i], xx + fy * xxy);
          store(&s.gradient[1][i], xy + fx * xxy);
          store(&s.gradient[2][i], yx + fy * yxy);
          store(&s.gradient[3][i], yy + fx * yxy);
        }
      });
}

inline void gather_motion_plane_linear(Block& block) {
  gather_velocity_plane_linear(block);
  gather_gradient_plane_linear(block);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
