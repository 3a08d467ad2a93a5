#pragma once

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"

/// A block as kernels see it that are compiled for one number type.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

using RealArray = BlockArray<Real>;
using RealScratch = TransferScratch<Real>;

inline RealScratch& scratch_of(const Block& block) { return static_cast<RealScratch&>(*block.scratch); }
/// A component of a vector of the particles whose first component is `a`.
inline Real* component_of(const Block& block, Attribute a, int axis) { return block.component<Real>(a, axis); }

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
