#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <stdexcept>
#include <vector>

/// Lowest solutions of sparse symmetric eigenvalue problems.
namespace trajan {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct Eigenmode {
  double value = 0;
  Eigen::VectorXd shape;  ///< of mass 1: shape^T M shape; of buckling: of stiffness 1
  /// Norm of K shape - value M shape, by that of value M shape or its like of buckling; of rigid ones by that of
  /// about the highest value times M shape.
  double residual = 0;
  bool rigid = false;  ///< its value is zero but for rounding
};

/// The problem has no such solutions, or they were not found.
class NoModes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Called every now and then; ends the search by throwing.
using Interruption = std::function<void()>;

/// The `count` lowest values of K shape = value M shape, ascending, by shift-and-invert Lanczos (Ericsson and
/// Ruhe 1980) with implicit restarts. K is positive semidefinite but for a few unstable modes, M positive
/// definite. Sylvester's law of inertia makes sure that none is missing, be it one of a degenerate pair. Fewer
/// only if the matrices have fewer rows. Throws NoModes.
std::vector<Eigenmode> lowest_modes(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                                    const Interruption& interruption = {});

/// The `count` smallest positive factors `value` of (K + value G) shape = 0, ascending; K is positive definite.
/// Fewer if there are fewer. Throws NoModes.
std::vector<Eigenmode> critical_factors(const SparseMatrix& stiffness, const SparseMatrix& geometric, int count,
                                        const Interruption& interruption = {});

}  // namespace trajan
