#pragma once

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"
#include "solver/schemes/kernels.h"

/// Stages that change particles by what has been gathered for them, whatever their law.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// v += dt a.
inline void kick(Block& block) {
  Scratch& s = *block.scratch;
  double* vx = block[Attribute::velocity_x];
  double* vy = block[Attribute::velocity_y];
  const double dt = block.sweep->kick;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    vx[i] += dt * s.acceleration[0][i];
    vy[i] += dt * s.acceleration[1][i];
  }
}

/// A blend of FLIP, v + dt a, and PIC, the grid's velocity (Stomakhin et al. 2013).
inline void kick_and_blend(Block& block) {
  Scratch& s = *block.scratch;
  double* vx = block[Attribute::velocity_x];
  double* vy = block[Attribute::velocity_y];
  const double dt = block.sweep->kick, flip = block.sweep->flip, pic = 1 - flip;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    vx[i] = flip * (vx[i] + dt * s.acceleration[0][i]) + pic * s.velocity[0][i];
    vy[i] = flip * (vy[i] + dt * s.acceleration[1][i]) + pic * s.velocity[1][i];
  }
}

/// x += dt u.
inline void move(Block& block) {
  Scratch& s = *block.scratch;
  const SweepConstants& c = *block.sweep;
  double* x = block[Attribute::position_x];
  double* y = block[Attribute::position_y];
  std::int64_t far = 0, left = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const double dx = c.drift * s.velocity[0][i], dy = c.drift * s.velocity[1][i];
    x[i] += dx;
    y[i] += dy;
    far += !((dx <= c.cell) & (-dx <= c.cell) & (dy <= c.cell) & (-dy <= c.cell));
    left += !((x[i] >= c.lower_x) & (x[i] <= c.upper_x) & (y[i] >= c.lower_y) & (y[i] <= c.upper_y));
  }
  s.trouble.moved_too_far += far;
  s.trouble.left_domain += left;
}

/// u += dt v: as `move`, where shape functions stay with the reference position.
inline void displace(Block& block) {
  Scratch& s = *block.scratch;
  const SweepConstants& c = *block.sweep;
  double* ux = block[Attribute::displacement_x];
  double* uy = block[Attribute::displacement_y];
  const double* x = block[Attribute::position_x];
  const double* y = block[Attribute::position_y];
  std::int64_t far = 0, left = 0;
#pragma GCC ivdep
  for (int i = 0; i < block.count; ++i) {
    const double dx = c.drift * s.velocity[0][i], dy = c.drift * s.velocity[1][i];
    ux[i] += dx;
    uy[i] += dy;
    const double px = x[i] + ux[i], py = y[i] + uy[i];
    far += !((dx <= c.cell) & (-dx <= c.cell) & (dy <= c.cell) & (-dy <= c.cell));
    left += !((px >= c.lower_x) & (px <= c.upper_x) & (py >= c.lower_y) & (py <= c.upper_y));
  }
  s.trouble.moved_too_far += far;
  s.trouble.left_domain += left;
}

inline void measure_motion(const Block& block, Totals& totals) {
  const double* vx = block[Attribute::velocity_x];
  const double* vy = block[Attribute::velocity_y];
  double sum_x = 0, sum_y = 0, squares = 0, largest = totals.squared_speed;
  for (int i = 0; i < block.count; ++i) {
    const double square = vx[i] * vx[i] + vy[i] * vy[i];
    sum_x += vx[i];
    sum_y += vy[i];
    squares += square;
    if (square > largest) largest = square;
  }
  totals.momentum_x += block.body->mass * sum_x;
  totals.momentum_y += block.body->mass * sum_y;
  totals.kinetic_energy += 0.5 * block.body->mass * squares;
  totals.squared_speed = largest;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
