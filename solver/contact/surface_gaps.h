#pragma once

#include "solver/boundaries/body_gaps.h"
#include "solver/contact/body_surface.h"
#include "solver/executors/block.h"
#include "solver/executors/tiles.h"
#include "solver/simulation/particles.h"

namespace trajan {

/// By the boundaries that bodies began with, as between bodies (solver/contact/meeting.h): the mean of what faces
/// the rigid surface beside the node; by particles where bodies have torn, and wherever these are deeper. May be
/// asked by several threads at once.
class SurfaceGaps : public BodyGaps {
 public:
  /// Whether there is anything to measure, where particles lie.
  static bool are_needed(const Model& model);
  SurfaceGaps(const Model& model, const Tiles& tiles, const std::vector<BodyParticles>& bodies,
              const SweepConstants& sweep);
  void find(std::size_t tile, std::uint64_t nodes, const RigidShape& shape, std::span<double> gaps) const override;

 private:
  const Tiles& tiles_;
  const std::vector<BodyParticles>& bodies_;
  const SweepConstants& sweep_;
  std::vector<BodySurface> surfaces_;  ///< by body
};

}  // namespace trajan
