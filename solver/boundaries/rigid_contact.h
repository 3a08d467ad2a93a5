#pragma once

#include <memory>

#include "solver/boundaries/prescribed_nodes.h"

namespace trajan {

/// A rigid plane or ball that nodes within it cannot enter further (Stomakhin et al. 2013, section 8;
/// Bardenhagen et al. 2001): the velocity relative to it loses its normal part, and of its tangential part
/// as much as Coulomb friction takes with that normal impulse.
class RigidContact : public Condition {
 public:
  static void make(const Model& model, std::vector<std::unique_ptr<Condition>>& conditions);
  /// `condition`: index into Model::conditions.
  RigidContact(const Model& model, const RigidObstacle& obstacle, std::size_t condition);
  bool works() const override { return true; }
  void bind(std::span<const TileNodes> tiles, HeldComponents& held) override;
  void prepare(const Kick& kick) override;
  void act(std::size_t tile, const TileNodes& nodes, std::span<Reaction> reactions) override;
  void act_on_mapped(std::size_t tile, const TileNodes& nodes) const override;

 private:
  using Components = std::array<double, 3>;
  /// Outward normal, and how far outside a place is; < 0 within.
  double distance(Vector at, Components& normal) const;
  bool may_touch(const TileNodes& nodes) const;
  enum class Touch : std::uint8_t { none, slides, sticks };
  /// The change of a relative velocity; components that others prescribe stay.
  Touch respond(const Components& relative, Components normal, unsigned held, Components& change) const;

  const RigidObstacle& obstacle_;
  std::size_t condition_;
  GridFrame frame_;
  PrescribedVelocities velocities_;
  Vector point_;           ///< of the plane or the ball's centre, now
  Components velocity_{};  ///< after the kick
  double kick_ = 0;
  const HeldComponents* held_ = nullptr;
  std::vector<Touch> touches_;  ///< by tile and node: what happened in the last kick
};

}  // namespace trajan
