#pragma once

#include "solver/boundaries/prescribed_nodes.h"
#include "solver/boundaries/surface_condition.h"

namespace trajan {

/// Gives means of a surface's acceleration and velocity, each by the one impulse that does it: the constrained
/// motion of least kinetic energy change, without penalty and whatever the place of the nodes. Both are given, as
/// on nodes: with the mass matrix M, weights c and P = 1 - c c^T / (c^T M^-1 c) M^-1 particles gain f^T P^T v from
/// the forces f and the velocity v that they map, and deform by P^T v. An impulse that also removed c^T v, which
/// mapping alone has made, would take energy in every step.
class HingeCondition : public SurfaceCondition {
 public:
  static void make(const Model& model, std::vector<std::unique_ptr<SurfaceCondition>>& conditions);
  HingeCondition(const Model& model, const HeldSurface& surface, std::size_t condition);
  bool works() const override { return true; }
  void prepare(const Kick& kick) override;
  Reaction act(Tiles& tiles, const HeldComponents& held) override;
  void act_on_mapped(Tiles& tiles, const HeldComponents& held) const override;
  void advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift) override;
  void constrain(double from, double to, MeanConstraints& constraints) const override;

 private:
  const HeldSurface& surface_;
  PrescribedVelocities velocities_;
  double kick_ = 0;
  std::array<PrescribedVelocities::Value, 3> velocity_{};
  std::array<double, 3> moved_{};  ///< displacement after the drift
};

}  // namespace trajan
