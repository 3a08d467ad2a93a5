#pragma once

#include <cmath>
#include <type_traits>

#include "solver/schemes/kernels.h"
#include "solver/transfers/real.h"
#include "solver/transfers/registers.h"
#include "solver/transfers/rounding.h"

/// Stages that change particles by what has been gathered for them, whatever their law.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// v += dt a.
template <int D>
inline void kick(Block& block) {
  const Real dt = Real(block.sweep->kick);
  for (int axis = 0; axis < D; ++axis) {
    Real* v = component_of(block, Attribute::velocity_x, axis);
    const Real* a = scratch_of(block).acceleration[axis].data();
    const Rounding rounded(block, static_cast<Attribute>(axis));
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) v[i] = rounded.add(v[i], dt * a[i], i);
  }
}

/// A blend of FLIP, v + dt a, and PIC, the grid's velocity (Stomakhin et al. 2013).
template <int D>
inline void kick_and_blend(Block& block) {
  const double dt = block.sweep->kick, flip = block.sweep->flip, pic = 1 - flip;
  for (int axis = 0; axis < D; ++axis) {
    Real* v = component_of(block, Attribute::velocity_x, axis);
    const Real* a = scratch_of(block).acceleration[axis].data();
    const Real* u = scratch_of(block).velocity[axis].data();
    const Rounding rounded(block, static_cast<Attribute>(axis));
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) v[i] = rounded(flip * (v[i] + dt * a[i]) + pic * u[i], i);
  }
}

/// v = u, the velocity that has been gathered.
template <int D>
inline void take_velocity(Block& block) {
  for (int axis = 0; axis < D; ++axis) {
    Real* v = component_of(block, Attribute::velocity_x, axis);
    const Real* u = scratch_of(block).velocity[axis].data();
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) v[i] = u[i];
  }
}

/// The other way round.
template <int D>
inline void own_velocity(Block& block) {
  for (int axis = 0; axis < D; ++axis) {
    const Real* v = component_of(block, Attribute::velocity_x, axis);
    Real* u = scratch_of(block).velocity[axis].data();
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) u[i] = v[i];
  }
}

/// Advances a vector of positions or displacements by the grid's velocity. `origin` is what it counts from,
/// nullptr: positions themselves. That there are particles that go too far is counted once for all of them;
/// they are known by their velocity: in floats eight comparisons at once.
inline void advance_along(Block& block, int axis, double* x, const double* origin) {
  using Flags = std::conditional_t<std::is_same_v<Real, double>, std::int64_t, std::int32_t>;
  RealScratch& s = scratch_of(block);
  const SweepConstants& c = *block.sweep;
  const Real* u = s.velocity[axis].data();
  const Real fastest = Real(c.cell / c.drift);
  const double drift = c.drift, lower = c.lower[axis], upper = c.upper[axis];
  Flags far = 0;
  std::int64_t left = 0;
  const auto advance = [&](auto place) __attribute__((always_inline)) {
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      // Neither holds of what is not a number.
      far |= std::abs(u[i]) <= fastest ? Flags{0} : Flags{-1};
      x[i] = multiply_add(drift, static_cast<double>(u[i]), x[i]);
      left |= place(i) >= lower ? std::int64_t{0} : std::int64_t{-1};
      left |= place(i) <= upper ? std::int64_t{0} : std::int64_t{-1};
    }
  };
  if (origin)
    advance([=](int i) { return origin[i] + x[i]; });
  else
    advance([=](int i) { return x[i]; });
  s.trouble.moved_too_far += far != 0;
  s.trouble.left_domain += left != 0;
}

/// x += dt u.
template <int D>
inline void move(Block& block) {
  for (int axis = 0; axis < D; ++axis)
    advance_along(block, axis, block.component(Attribute::position_x, axis), nullptr);
}

/// As `move`, where shape functions stay with the reference position.
template <int D>
inline void displace(Block& block) {
  for (int axis = 0; axis < D; ++axis)
    advance_along(block, axis, block.component(Attribute::displacement_x, axis),
                  block.component(Attribute::position_x, axis));
}

/// Acceleration by loads: the body's, and what is the particle's own.
template <int D>
inline void find_loads(Block& block) {
  for (int axis = 0; axis < D; ++axis) {
    Real* load = scratch_of(block).load[axis].data();
    const double* own = block.component(Attribute::load_x, axis);
    const double common = block.body->acceleration[axis];
    for (int i = 0; i < block.count; ++i) load[i] = Real(common + (own ? own[i] : 0.0));
  }
}

template <int D>
inline void measure_motion(const Block& block, Totals& totals) {
  double squares = 0, largest = totals.squared_speed, sums[D] = {};
  for (int i = 0; i < block.count; ++i) {
    const double mass = block.mass(i);
    double square = 0;
    for (int axis = 0; axis < D; ++axis) {
      const double v = component_of(block, Attribute::velocity_x, axis)[i];
      sums[axis] += mass * v;
      square += v * v;
    }
    squares += mass * square;
    if (square > largest) largest = square;
  }
  for (int axis = 0; axis < D; ++axis) totals.momentum[axis] += sums[axis];
  totals.kinetic_energy += 0.5 * squares;
  totals.squared_speed = largest;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
