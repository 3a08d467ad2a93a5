#pragma once

#include "solver/transfers/plane_linear.h"

/// Particles to grid with bilinear shape functions (Sulsky, Chen and Schreyer 1994), the four nodes of a cell
/// at a time.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Adds the four corners' values to a node quantity of a window.
__attribute__((always_inline)) inline void add_corners(double* sum, Four corners) {
  add(sum, Pair{corners[0], corners[1]});
  add(sum + plane_linear_layout.window_side, Pair{corners[2], corners[3]});
}

/// Shape functions of the four nodes of a cell, in the order of their indices, as products along the axes.
struct Corners {
  Four x, y;
  __attribute__((always_inline)) Corners(Real fx, Real fy)
      : x(Four{1, 0, 1, 0} + Four{-1, 1, -1, 1} * fx), y(Four{1, 1, 0, 0} + Four{-1, -1, 1, 1} * fy) {}
};

/// The sums of one vector's component, from a cell's first node on.
__attribute__((always_inline)) inline double* sums_of_cell(const Block& block, SumVector vector, int axis,
                                                           std::int64_t k) {
  return block.sums + quantity(vector, axis, 2) * plane_linear_layout.window_nodes + k;
}

/// Mass, momentum and internal force.
inline void scatter_state_plane_linear(Block& block) {
  RealScratch& s = scratch_of(block);
  const Real mass = Real(block.body->mass);
  const Real* vx = component_of(block, Attribute::velocity_x, 0);
  const Real* vy = component_of(block, Attribute::velocity_x, 1);
  const RealArray* force = s.force_on_nodes();
  s.trouble.runs += count_runs(block);
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        Four weight{}, px{}, py{}, forces_x{}, forces_y{};
        for (int i = begin; i < end; ++i) {
          const Corners n(s.place[0][i], s.place[1][i]);
          const Four w = n.x * n.y;
          // Minus the gradient of the shape functions, in cells.
          const Four gx = Four{1, -1, 1, -1} * n.y, gy = Four{1, 1, -1, -1} * n.x;
          weight += w;
          px += w * vx[i];
          py += w * vy[i];
          forces_x += gx * force[0][i] + gy * force[1][i];
          forces_y += gx * force[2][i] + gy * force[3][i];
        }
        add_corners(block.sums + k, weight * mass);
        add_corners(sums_of_cell(block, sum_momentum, 0, k), px * mass);
        add_corners(sums_of_cell(block, sum_momentum, 1, k), py * mass);
        add_corners(sums_of_cell(block, sum_force, 0, k), forces_x);
        add_corners(sums_of_cell(block, sum_force, 1, k), forces_y);
      });
}

inline void scatter_mass_plane_linear(Block& block) {
  RealScratch& s = scratch_of(block);
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        Four weight{};
        for (int i = begin; i < end; ++i) {
          const Corners n(s.place[0][i], s.place[1][i]);
          weight += n.x * n.y;
        }
        add_corners(block.sums + k, weight * Real(block.body->mass));
      });
}

/// A vector that particles have, times their mass.
inline void scatter_vector_plane_linear(Block& block, SumVector vector, const Real* x, const Real* y) {
  RealScratch& s = scratch_of(block);
  const Real mass = Real(block.body->mass);
  for_each_run(
      block, [&](int begin, int end, std::int64_t k) __attribute__((always_inline)) {
        Four px{}, py{};
        for (int i = begin; i < end; ++i) {
          const Corners n(s.place[0][i], s.place[1][i]);
          const Four w = n.x * n.y;
          px += w * x[i];
          py += w * y[i];
        }
        add_corners(sums_of_cell(block, vector, 0, k), px * mass);
        add_corners(sums_of_cell(block, vector, 1, k), py * mass);
      });
}

/// Momentum alone, for the second mapping of MUSL.
inline void scatter_momentum_plane_linear(Block& block) {
  scatter_vector_plane_linear(block, sum_momentum, component_of(block, Attribute::velocity_x, 0),
                              component_of(block, Attribute::velocity_x, 1));
}
inline void scatter_loads_plane_linear(Block& block) {
  scatter_vector_plane_linear(block, sum_load, scratch_of(block).load[0].data(), scratch_of(block).load[1].data());
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
