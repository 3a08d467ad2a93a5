#pragma once

#include "solver/implicit/newton_iterations.h"

namespace trajan {

/// A path of equilibria, where it has got to.
struct Path {
  double load_time = 0;        ///< whose loads are in balance
  double length_per_time = 0;  ///< of displacements of the free unknowns; 0: not known yet
  Eigen::VectorXd direction;   ///< the last step of the free unknowns; empty: there was none
};

/// Newton's method where the time of the loads is an unknown as well, and the step of the free unknowns has a
/// given length (Crisfield 1981, the cylindrical method with two roots of which the one that turns less is taken).
class ArcLengthIterations : public NewtonIterations {
 public:
  /// `first_load`: time of the loads that the first step goes to, had the path no curvature.
  ArcLengthIterations(const Newton& options, SparseSolver& solver, StepBalance& balance, const Path& path,
                      double first_load);
  State iterate() override;

  /// The path after this step.
  Path path() const { return {load_time_, length_per_time_, free_}; }

 private:
  bool correct(const Eigen::VectorXd& by_residual, const Eigen::VectorXd& by_load);

  Path before_;
  double first_load_, load_time_, length_per_time_, length_ = 0;
  Eigen::VectorXd free_;  ///< displacement of the free unknowns
};

}  // namespace trajan
