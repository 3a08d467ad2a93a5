#pragma once

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"

/// Particles to grid and back with bilinear shape functions (Sulsky, Chen and Schreyer 1994). Particles are
/// ordered by cell: what is the same for a run of consecutive particles in one cell is done once.
/// Gathering works on four particles at a time, scattering on the four nodes of a cell.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

typedef double Four __attribute__((vector_size(32)));
typedef double Pair __attribute__((vector_size(16)));

template <class Vector>
__attribute__((always_inline)) inline Vector load(const double* from) {
  Vector value;
  __builtin_memcpy(&value, from, sizeof value);
  return value;
}
template <class Vector>
__attribute__((always_inline)) inline void store(double* to, Vector value) {
  __builtin_memcpy(to, &value, sizeof value);
}

/// Cell and place in it. A particle that is not where its tile allows is put to the nearest place that is,
/// so that what follows is harmless, and counted.
inline void locate(Block& block) {
  Scratch& s = *block.scratch;
  const SweepConstants& c = *block.sweep;
  const double* x = block[Attribute::position_x];
  const double* y = block[Attribute::position_y];
  const double below = 1 - 0x1p-40;
  const double x0 = block.lowest_x, x1 = block.highest_x + below;
  const double y0 = block.lowest_y, y1 = block.highest_y + below;
  std::int64_t left = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const double cx = (x[i] - c.origin_x) * c.inverse_cell - block.window_x;
    const double cy = (y[i] - c.origin_y) * c.inverse_cell - block.window_y;
    const double ax = cx > x0 ? cx : x0;
    const double ay = cy > y0 ? cy : y0;
    const double bx = ax < x1 ? ax : x1;
    const double by = ay < y1 ? ay : y1;
    const int column = static_cast<int>(bx);
    const int row = static_cast<int>(by);
    left += (bx != cx) | (by != cy);
    s.cell[i] = row * window_side + column;
    s.fx[i] = bx - column;
    s.fy[i] = by - row;
  }
  s.trouble.left_window += left;
}

/// Calls of(begin, end, cell) for every run of consecutive particles in one cell.
template <class Function>
__attribute__((always_inline)) inline void for_each_run(const Block& block, Function&& of) {
  const std::int64_t* cell = block.scratch->cell;
  for (int begin = 0; begin < block.count;) {
    int end = begin + 1;
    while (end < block.count && cell[end] == cell[begin]) ++end;
    of(begin, end, cell[begin]);
    begin = end;
  }
}

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

/// Velocity of the grid and gradient of `Gradient`, the velocity itself or the one mapped a second time.
template <NodeValue Gradient>
inline void gather_motion(Block& block) {
  Scratch& s = *block.scratch;
  const WindowValue& ux = s.window.values[node_velocity_x];
  const WindowValue& uy = s.window.values[node_velocity_y];
  const WindowValue& wx = s.window.values[Gradient];
  const WindowValue& wy = s.window.values[Gradient + 1];
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

/// Adds the four corners' values to a node quantity of a window.
__attribute__((always_inline)) inline void add_corners(double* sum, Four corners) {
  const Pair lower = {corners[0], corners[1]}, upper = {corners[2], corners[3]};
  store(sum, load<Pair>(sum) + lower);
  store(sum + window_side, load<Pair>(sum + window_side) + upper);
}

/// Shape functions of the four nodes of a cell, in the order of their indices, as products along the axes.
struct Corners {
  Four x, y;
  __attribute__((always_inline)) Corners(double fx, double fy)
      : x(Four{1, 0, 1, 0} + Four{-1, 1, -1, 1} * fx), y(Four{1, 1, 0, 0} + Four{-1, -1, 1, 1} * fy) {}
};

/// Mass, momentum, internal force, and loads on the body's mass.
template <bool Loads>
inline void scatter_state(Block& block) {
  Scratch& s = *block.scratch;
  const double mass = block.body->mass;
  const double* vx = block[Attribute::velocity_x];
  const double* vy = block[Attribute::velocity_y];
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        Four weight{}, px{}, py{}, forces_x{}, forces_y{};
        for (int i = begin; i < end; ++i) {
          const Corners n(s.fx[i], s.fy[i]);
          const Four w = n.x * n.y;
          // Minus the gradient of the shape functions, in cells.
          const Four gx = Four{1, -1, 1, -1} * n.y, gy = Four{1, 1, -1, -1} * n.x;
          weight += w;
          px += w * vx[i];
          py += w * vy[i];
          forces_x += gx * s.force[0][i] + gy * s.force[1][i];
          forces_y += gx * s.force[2][i] + gy * s.force[3][i];
        }
        weight *= mass;
        double* sums = block.sums + k;
        add_corners(sums + sum_mass * window_nodes, weight);
        add_corners(sums + sum_momentum_x * window_nodes, px * mass);
        add_corners(sums + sum_momentum_y * window_nodes, py * mass);
        add_corners(sums + sum_force_x * window_nodes, forces_x);
        add_corners(sums + sum_force_y * window_nodes, forces_y);
        if constexpr (Loads) {
          add_corners(sums + sum_load_x * window_nodes, weight * block.body->acceleration_x);
          add_corners(sums + sum_load_y * window_nodes, weight * block.body->acceleration_y);
        }
      });
}

/// Momentum alone, for the second mapping of MUSL.
inline void scatter_momentum(Block& block) {
  Scratch& s = *block.scratch;
  const double mass = block.body->mass;
  const double* vx = block[Attribute::velocity_x];
  const double* vy = block[Attribute::velocity_y];
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        Four px{}, py{};
        for (int i = begin; i < end; ++i) {
          const Corners n(s.fx[i], s.fy[i]);
          const Four w = n.x * n.y;
          px += w * vx[i];
          py += w * vy[i];
        }
        double* sums = block.sums + k;
        add_corners(sums + sum_momentum_x * window_nodes, px * mass);
        add_corners(sums + sum_momentum_y * window_nodes, py * mass);
      });
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
