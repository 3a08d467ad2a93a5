#pragma once

#include "solver/transfers/cells.h"

/// Particles to grid with bilinear shape functions (Sulsky, Chen and Schreyer 1994), the four nodes of a cell
/// at a time.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

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
