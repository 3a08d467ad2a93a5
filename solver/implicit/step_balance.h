#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "solver/implicit/constraints.h"
#include "solver/implicit/external_forces.h"
#include "solver/implicit/responses.h"

namespace trajan {

/// The grid at the places where particles are at present, and what is summed on it.
struct GridView {
  Discretization on;
  GhostPenalty ghost;
  Assembly assembly;
  GridView(const Model& model, Executor& executor)
      : on(model, executor), ghost(model, on), assembly(on, ghost, executor.pool()) {}
};

/// Share of the forces and of the inertia in what is to vanish at the end of a step:
/// forces_share (external - internal)(u) - inertia M u + constant.
struct Inertia {
  double forces_share = 1;
  double of_displacement = 0;
  Eigen::VectorXd constant;  ///< empty: zero
  const SparseMatrix* mass = nullptr;
};

/// The balance of forces of one step, as a function of the displacement of the nodes since its beginning.
class StepBalance {
 public:
  /// Throws FormulaNotFinite.
  /// From and to are those of loads and prescribed motions; for the materials it takes `duration`.
  StepBalance(const Model& model, Executor& executor, const GridView& view, Responses& responses, double from,
              double to, double duration);

  /// What is missing to balance after a displacement. False: the materials have no answer.
  bool evaluate(const Eigen::VectorXd& displacement);
  /// By default there is none. Evaluates again, without displacement.
  void set_inertia(Inertia inertia);

  const Eigen::VectorXd& residual() const { return residual_; }
  const Eigen::VectorXd& internal() const { return internal_; }
  const Eigen::VectorXd& external() const { return external_; }
  const Eigen::VectorXd& internal_before() const { return internal_before_; }
  const Eigen::VectorXd& external_before() const { return external_before_; }
  const Constraints& constraints() const { return constraints_; }
  const Responses::Trouble& trouble() const { return trouble_; }
  /// The residual as the free unknowns see it.
  Eigen::VectorXd reduced_residual() const { return constraints_.expand().transpose() * residual_; }
  /// The norm of the forces that balance.
  double scale() const;
  /// Minus the derivative of the residual at the last displacement, of all unknowns.
  SparseMatrix tangent();
  /// Work of external forces and of reactions over a displacement that ends in balance. `before`, `after`: what
  /// inertia takes; empty: nothing.
  double work(const Eigen::VectorXd& displacement, const Eigen::VectorXd& before = {},
              const Eigen::VectorXd& after = {}) const;
  double to() const { return to_; }
  double from() const { return from_; }
  double duration() const { return duration_; }
  /// Moves the end to loads of another time; prescribed motions stay.
  void set_end(double to) { to_ = to; }
  /// Derivative of external forces by time at the end and the last displacement, from a difference over twice this
  /// time.
  Eigen::VectorXd load_rate(double step);

 private:
  Eigen::VectorXd external_at(double time, const Eigen::VectorXd& displacement, SparseMatrix* stiffness = nullptr);

  const GridView& view_;
  Responses& responses_;
  ExternalForces loads_;
  double from_, to_, duration_;
  Constraints constraints_;
  Inertia inertia_;
  Responses::Trouble trouble_;
  Eigen::VectorXd displacement_, residual_, internal_, external_, internal_before_, external_before_;
};

}  // namespace trajan
