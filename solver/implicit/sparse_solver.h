#pragma once

#include <Eigen/Core>
#include <memory>

#include "solver/executors/thread_pool.h"
#include "solver/implicit/assembly.h"
#include "solver/implicit/places.h"
#include "solver/scene/analysis.h"

namespace trajan {

/// Solves sparse systems, one after the other; what depends on the pattern alone is done again only if the pattern
/// has changed. Where factors would be too large or too much work, conjugate gradients take their place,
/// preconditioned by multigrid if it is known where unknowns lie. Rows and columns are scaled to a diagonal of
/// ones first, so that condition numbers do not depend on units or on how much of a node's surroundings is filled.
class SparseSolver {
 public:
  /// Multigrid's cycles take the threads of the pool; none: one.
  explicit SparseSolver(LinearSolver choice, ThreadPool* pool = nullptr);
  ~SparseSolver();

  struct Factors {
    /// false: the matrix is singular, but for rounding, or neither iterations nor factors of a size that is
    /// allowed solve it
    bool regular = false;
    bool positive_definite = false;  ///< and symmetric
    /// An estimate of the inverse condition number from the diagonal of the factors; of multigrid that of the
    /// coarsest grid, of other iterative solutions 1.
    double reciprocal_condition = 0;
  };
  /// `places`: of the unknowns, as many as rows; none: nobody knows.
  Factors factorize(SparseMatrix matrix, const Places& places = {});
  /// With the last factors. An iterative solution is as good as `tolerance`, a share of the right-hand side of the
  /// scaled system. Where iterations do not get there factors are tried after all, and if they are too large
  /// factors() are not regular any more: what is returned solves nothing, but goes where the matrix gives way.
  Eigen::VectorXd solve(const Eigen::VectorXd& right, double tolerance = 1e-12) const;
  /// Gives back the memory of a matrix that has no factors: before the next one is made.
  void release();
  /// What is known of the matrix, by solving too.
  const Factors& factors() const;
  /// Of the last solution, 0: by factors.
  int iterations() const;

 private:
  struct Methods;
  LinearSolver choice_;
  std::unique_ptr<Methods> methods_;
};

}  // namespace trajan
