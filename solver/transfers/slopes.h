#pragma once

#include "solver/transfers/real.h"

/// Where a stencil finds the factors of its slopes.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

struct ShapeSlopes {
  static const RealArray* along(const RealScratch& s, int axis) { return s.slope[axis]; }
};
struct LeverSlopes {
  static const RealArray* along(const RealScratch& s, int axis) { return s.levers[axis].lever; }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
