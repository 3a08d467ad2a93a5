#pragma once

#include <type_traits>

#include "solver/executors/block.h"
#include "solver/executors/floats.h"
#include "solver/executors/instruction_set.h"

/// A block as kernels see it that are compiled for one number type.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

using RealArray = BlockArray<Real>;
using RealScratch = TransferScratch<Real>;

inline RealScratch& scratch_of(const Block& block) { return static_cast<RealScratch&>(*block.scratch); }
/// A component of a vector of the particles whose first component is `a`.
inline Real* component_of(const Block& block, Attribute a, int axis) { return block.component<Real>(a, axis); }

/// A component of a particle's deformation gradient.
inline Real deformation_of(const Block& block, int row, int column, int i) {
  const auto attribute = static_cast<Attribute>(static_cast<int>(Attribute::deformation_xx) + 3 * row + column);
  const Real stored = block.component<Real>(attribute)[i];
  return std::is_same_v<Real, double> ? stored : static_cast<Real>(value_at_rest(attribute)) + stored;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
