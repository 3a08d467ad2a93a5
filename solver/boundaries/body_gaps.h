#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/boundaries/rigid_shape.h"

namespace trajan {

/// Measures how far bodies are from rigid surfaces.
class BodyGaps {
 public:
  virtual ~BodyGaps() = default;
  /// For those nodes of a tile whose bits are set, by node: how far the surface of what has mass there is from the
  /// shape near the node, < 0 within it; infinite if nothing is near.
  virtual void find(std::size_t tile, std::uint64_t nodes, const RigidShape& shape,
                    std::span<double> gaps) const = 0;
};

}  // namespace trajan
