#pragma once

#include <vector>

#include "solver/implicit/sparse_solver.h"
#include "solver/implicit/step_balance.h"

namespace trajan {

/// Newton's method with consistent tangents on the balance of one step. Prescribed displacements enter the first
/// iteration linearized, so that the body as a whole takes them up and not the cells at its boundary.
class NewtonIterations {
 public:
  NewtonIterations(const Newton& options, SparseSolver& solver, StepBalance& balance);
  virtual ~NewtonIterations() = default;

  enum class State { going, converged, failed };
  enum class Failure { none, no_answer, singular, unsolved, too_slow, no_load };
  /// One more iteration.
  virtual State iterate();

  const Eigen::VectorXd& displacement() const { return displacement_; }
  int iterations() const { return static_cast<int>(residuals_.size()); }
  /// After each iteration, as a share of the forces that balance.
  const std::vector<double>& residuals() const { return residuals_; }
  Failure failure() const { return failure_; }
  const SparseSolver::Factors& factors() const { return factors_; }
  /// The displacement of all unknowns that meets the least resistance of the last tangent.
  Eigen::VectorXd weakest() const;
  /// The forces of all unknowns that are missing for balance, but reactions.
  Eigen::VectorXd missing() const;
  /// What the rounding of strains, which are differences of numbers about 1, leaves of the forces at most, as a
  /// share of those that balance. `cell` is the size of one.
  double rounding(double cell) const;

 protected:
  State fail(Failure why);
  /// Whether the residual is small enough.
  State judge();

  const Newton& options_;
  SparseSolver& solver_;
  StepBalance& balance_;
  Eigen::VectorXd displacement_;
  std::vector<double> residuals_;
  Failure failure_ = Failure::none;
  SparseSolver::Factors factors_;

 private:
  /// Goes as far along the direction as is good. False: there is no answer that way.
  bool advance(const Eigen::VectorXd& direction, const Eigen::VectorXd& reduced);
  double prescribed_scale_ = 0;
};

}  // namespace trajan
