#pragma once

#include "solver/transfers/real.h"
#include "solver/transfers/vectors.h"

/// Where stencils find the factors of their slopes: `along` of one particle's nodes, `lanes` of several
/// particles'.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Kind>
struct StoredSlopes {
  template <class Particles>
  static auto lanes(const RealScratch& s, int axis, int node, const Particles& particles) {
    return particles.load(Kind::along(s, axis)[node].values);
  }
};
struct ShapeSlopes : StoredSlopes<ShapeSlopes> {
  static const RealArray* along(const RealScratch& s, int axis) { return s.slope[axis]; }
};
struct LeverSlopes : StoredSlopes<LeverSlopes> {
  static const RealArray* along(const RealScratch& s, int axis) { return s.levers[axis].lever; }
  /// D over what levers are multiplied by.
  static Real inertia(const RealScratch& s, int axis, int i) { return s.levers[axis].inertia[i]; }
};
/// Weights times the distances of nodes, in cells: levers times D, where that is the same everywhere.
struct WeighedDistances {
  template <class Particles>
  static auto lanes(const RealScratch& s, int axis, int node, const Particles& particles) {
    return particles.load(s.weight[axis][node].values) * (Real(node) - particles.load(s.place[axis].values));
  }
  static Real inertia(const RealScratch&, int, int) { return 1; }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
