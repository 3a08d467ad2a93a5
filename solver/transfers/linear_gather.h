#pragma once

#include "solver/transfers/cells.h"

/// Grid to particles with bilinear shape functions (Sulsky, Chen and Schreyer 1994), four particles at a time.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// out = value of a node quantity at the particles. Writes up to three entries too many per run, which the
/// next run overwrites.
__attribute__((always_inline)) inline void interpolate(const WindowValue& v, std::int64_t k, Four fx, Four fy,
                                                       double* out) {
  store(out, v.base[k] + fx * v.dx[k] + fy * (v.dy[k] + fx * v.dxy[k]));
}

template <NodeValue First>
inline void gather_pair(Block& block, BlockArray (&out)[2]) {
  Scratch& s = *block.scratch;
  const WindowValue& vx = s.window.values[First];
  const WindowValue& vy = s.window.values[First + 1];
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        for (int i = begin; i < end; i += 4) {
          const Four fx = load<Four>(&s.fx[i]), fy = load<Four>(&s.fy[i]);
          interpolate(vx, k, fx, fy, &out[0][i]);
          interpolate(vy, k, fx, fy, &out[1][i]);
        }
      });
}

inline void gather_acceleration(Block& block) {
  gather_pair<node_acceleration_x>(block, block.scratch->acceleration);
}
inline void gather_acceleration_and_velocity(Block& block) {
  gather_acceleration(block);
  gather_pair<node_velocity_x>(block, block.scratch->velocity);
}

/// Velocity of the grid, and gradient of the one that is for gradients.
inline void gather_motion(Block& block) {
  Scratch& s = *block.scratch;
  const WindowValue& ux = s.window.values[node_velocity_x];
  const WindowValue& uy = s.window.values[node_velocity_y];
  const WindowValue& wx = s.window.values[node_mapped_velocity_x];
  const WindowValue& wy = s.window.values[node_mapped_velocity_y];
  const double q = block.sweep->inverse_cell;
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        const double xx = q * wx.dx[k], xy = q * wx.dy[k], xxy = q * wx.dxy[k];
        const double yx = q * wy.dx[k], yy = q * wy.dy[k], yxy = q * wy.dxy[k];
        for (int i = begin; i < end; i += 4) {
          const Four fx = load<Four>(&s.fx[i]), fy = load<Four>(&s.fy[i]);
          interpolate(ux, k, fx, fy, &s.velocity[0][i]);
          interpolate(uy, k, fx, fy, &s.velocity[1][i]);
          store(&s.gradient[0][i], xx + fy * xxy);
          store(&s.gradient[1][i], xy + fx * xxy);
          store(&s.gradient[2][i], yx + fy * yxy);
          store(&s.gradient[3][i], yy + fx * yxy);
        }
      });
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
