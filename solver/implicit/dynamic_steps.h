#pragma once

#include "solver/implicit/implicit_steps.h"

namespace trajan {

/// Time steps of implicit dynamics by the generalized-alpha method (Chung and Hulbert 1993), of which Newmark's
/// (1959) is a special case: forces are balanced at the share 1 - alpha_f, inertia at the share 1 - alpha_m of the
/// step.
///
/// In the total Lagrangian configuration nodes keep their velocities and accelerations. In the updated one
/// particles carry them from grid to grid with lumped masses, velocities by increments (Guilkey and Weiss 2003).
class DynamicSteps : public ImplicitSteps {
 public:
  DynamicSteps(const Model& model, const ImplicitDynamics& analysis, Executor& executor, const Checkpoint* resume);
  void save(Checkpoint& checkpoint) const override;

 private:
  struct Weights {
    double alpha_m = 0, alpha_f = 0, beta = 0.25, gamma = 0.5;
    explicit Weights(const ImplicitDynamics& analysis);
  };
  void begin_step(StepBalance& balance) override;
  void end_step(const StepBalance& balance, const Eigen::VectorXd& displacement) override;
  bool needs_supports() const override { return false; }
  std::string where() const override { return "the time " + std::to_string(time()); }

  /// Velocities and accelerations of the nodes at the beginning, where there are none yet.
  void begin_motion(const StepBalance& balance);
  /// Of what particles carry, as means weighted with mass.
  void map_from_particles();
  void map_to_particles(const Eigen::VectorXd& velocity_change);

  const Model& model_;
  bool lumped_;
  Weights weights_;
  SparseMatrix mass_;
  Eigen::VectorXd velocity_, acceleration_;         ///< of the nodes, at the step's beginning
  std::vector<std::vector<double>> accelerations_;  ///< updated Lagrangian: by body, particle and axis
};

}  // namespace trajan
