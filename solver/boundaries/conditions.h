#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/boundaries/surface_condition.h"

namespace trajan {

/// All boundary conditions of a model.
class Conditions {
 public:
  explicit Conditions(const Model& model);
  /// Whether reactions can do work or consume energy.
  bool work() const { return work_; }
  /// Whether some act on surfaces, which is done once after all tiles.
  bool on_surfaces() const { return !on_surfaces_.empty(); }

  /// Gaps between bodies and rigid surfaces count.
  void measure_gaps_by(const BodyGaps& gaps) {
    for (auto& condition : on_nodes_) condition->measure_gaps_by(gaps);
  }
  /// Finds what is concerned after particles have been sorted.
  void bind(const std::vector<BodyParticles>& bodies, Tiles& tiles);
  /// Throws FormulaNotFinite.
  void prepare(const Kick& kick);
  /// How many there are, and so reactions; in the order of the model.
  std::size_t count() const { return count_; }
  /// Changes accelerations and velocities of a tile's nodes after a kick. Adds to the reactions.
  void act(std::size_t tile, std::span<Reaction> reactions);
  /// Makes the velocities fit that were mapped a second time.
  void act_on_mapped(std::size_t tile) const;
  /// What conditions on surfaces do, on all tiles.
  void act_on_surfaces(const std::vector<BodyParticles>& bodies, Tiles& tiles, std::span<Reaction> reactions);
  /// `moved`: particles are no longer where they were when forces acted.
  void act_on_mapped_surfaces(const std::vector<BodyParticles>& bodies, Tiles& tiles, bool moved);
  /// Makes a correction of a tile's velocities or accelerations zero where these are prescribed. `vector`: its
  /// components one after the other.
  void hold(std::size_t tile, double* vector) const;
  /// Components that are prescribed; empty: there are no conditions.
  const HeldComponents& held() const { return held_; }
  /// Moves surface points; to be called before the particles move.
  void advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift);
  /// What displacements between two times must be. Throws FormulaNotFinite.
  void constrain(const std::vector<BodyParticles>& bodies, const Tiles& tiles, double from, double to,
                 DisplacementConstraints& of_nodes, MeanConstraints& of_means);
  /// The points of the conditions on surfaces.
  std::vector<Riders*> riders() const;

 private:
  int axes_;  ///< of the grid
  std::size_t count_;
  std::vector<std::unique_ptr<Condition>> on_nodes_;
  std::vector<std::unique_ptr<SurfaceCondition>> on_surfaces_;
  std::vector<TileNodes> tiles_;
  HeldComponents held_;
  std::optional<Kick> kick_;  ///< the last one
  bool work_ = false;
};

}  // namespace trajan
