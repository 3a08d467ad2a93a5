#pragma once

#include <memory>

#include "solver/boundaries/body_gaps.h"
#include "solver/boundaries/prescribed_nodes.h"

namespace trajan {

/// A rigid plane or ball that nodes within it cannot enter further (Stomakhin et al. 2013, section 8;
/// Bardenhagen et al. 2001): the velocity relative to it loses its normal part, and of its tangential part
/// as much as Coulomb friction takes with that normal impulse. What may part again is felt when the gap between
/// the surfaces closes (solver/boundaries/body_gaps.h), not as soon as nodes within have mass.
class RigidContact : public Condition {
 public:
  static void make(const Model& model, std::vector<std::unique_ptr<Condition>>& conditions);
  /// `condition`: index into Model::conditions.
  RigidContact(const Model& model, const RigidObstacle& obstacle, std::size_t condition);
  bool works() const override { return true; }
  void bind(std::span<const TileNodes> tiles, HeldComponents& held) override;
  void measure_gaps_by(const BodyGaps& gaps) override;
  void prepare(const Kick& kick) override;
  void act(std::size_t tile, const TileNodes& nodes, std::span<Reaction> reactions) override;
  void act_on_mapped(std::size_t tile, const TileNodes& nodes) const override;

 private:
  /// Outward normal, and how far outside a node is; < 0 within.
  double distance(const TileNodes& nodes, int node, Components& normal) const;
  bool may_touch(std::size_t tile) const { return distances_[tile] <= travelled_; }
  Components relative_velocity(const TileNodes& nodes, int node) const;
  /// What closes in on the body from within it: the fastest that nodes may do so, by node.
  void find_allowed(std::size_t tile, const TileNodes& nodes, std::array<double, TileNodes::count>& allowed) const;
  enum class Touch : std::uint8_t { none, slides, sticks };
  /// The change of a relative velocity which may approach as fast as is allowed; components that others prescribe
  /// stay.
  Touch respond(const Components& relative, Components normal, double allowed, unsigned held,
                Components& change) const;

  const RigidObstacle& obstacle_;
  std::size_t condition_;
  GridFrame frame_;
  PrescribedVelocities velocities_;
  RigidShape shape_;                ///< now
  Components bound_at_{};           ///< where its point was when tiles were bound
  std::vector<double> distances_;   ///< of tiles from where it was, less than those of their nodes by a cell
  double travelled_ = 0;            ///< since then
  const BodyGaps* gaps_ = nullptr;  ///< none: nodes within are felt however far their bodies are
  Components velocity_{};           ///< after the kick
  double kick_ = 0, closing_time_ = 0;
  const HeldComponents* held_ = nullptr;
  std::vector<Touch> touches_;  ///< by tile and node: what happened in the last kick
};

}  // namespace trajan
