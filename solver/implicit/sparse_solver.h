#pragma once

#include <Eigen/Core>
#include <memory>

#include "solver/implicit/assembly.h"
#include "solver/scene/analysis.h"

namespace trajan {

/// Solves sparse systems, one after the other; what depends on the pattern alone is done again only if the pattern
/// has changed. Where factors would be too large, conjugate gradients take their place. Rows and columns are
/// scaled to a diagonal of ones first, so that condition numbers do not depend on units or on how much of a node's
/// surroundings is filled.
class SparseSolver {
 public:
  explicit SparseSolver(LinearSolver choice);
  ~SparseSolver();

  struct Factors {
    bool regular = false;            ///< false: the matrix is singular, but for rounding
    bool positive_definite = false;  ///< and symmetric
    /// An estimate of the inverse condition number from the diagonal of the factors; of iterative solutions 1.
    double reciprocal_condition = 0;
  };
  Factors factorize(SparseMatrix matrix);
  /// With the last factors. An iterative solution is as good as `tolerance`, a share of the right-hand side.
  Eigen::VectorXd solve(const Eigen::VectorXd& right, double tolerance = 1e-12) const;

 private:
  struct Methods;
  LinearSolver choice_;
  std::unique_ptr<Methods> methods_;
};

}  // namespace trajan
