#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "solver/implicit/cholesky.h"
#include "solver/implicit/coarsening.h"

namespace trajan {

/// A symmetric positive definite approximation of a matrix's inverse, whose quality hardly depends on the number
/// of cells: geometric multigrid on the background grid (Hackbusch 1985; Tatebe 1993 as a preconditioner). A
/// V-cycle has one sweep of Gauss and Seidel over the nodes forwards before the coarser grid's correction and one
/// backwards after it; the coarsest grid has a Cholesky factor.
class Multigrid {
 public:
  /// Of a symmetric matrix that has been scaled by rows and columns. It must stay where it is. False: it is not
  /// positive definite.
  bool build(const Eigen::SparseMatrix<double>& matrix, const Places& places, const Eigen::VectorXd& scale);
  /// An estimate of the coarsest grid's inverse condition number. Rigid motions that nothing holds are there, too.
  double reciprocal_condition() const { return reciprocal_condition_; }
  /// z becomes the approximation of what solves for r.
  void precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) { cycle(0, r, z); }
  /// y becomes the matrix times x.
  void multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y);

 private:
  using Rows = std::array<double, 3>;
  /// Rows of one node, which are solved for together.
  struct Node {
    int first, rows;
    bool alike;  ///< all have entries in the same columns
    int below;   ///< then: entries of each in columns before the node's own
    std::array<std::array<double, 3>, 3> inverse;
  };
  struct Level {
    Eigen::SparseMatrix<double> matrix;  ///< of coarser grids
    std::vector<Node> nodes;
    Interpolation interpolation;  ///< from the next level
    Eigen::VectorXd rest, right, answer;
  };
  /// Which entries of a row.
  enum class Part { whole, before_node, after_node };
  const Eigen::SparseMatrix<double>& matrix(std::size_t level) const {
    return level == 0 ? *finest_ : levels_[level].matrix;
  }
  bool find_nodes(std::size_t level, const Places& places);
  bool factorize_coarsest(Eigen::SparseMatrix<double> matrix);
  void cycle(std::size_t level, const Eigen::VectorXd& r, Eigen::VectorXd& z);
  /// Of the node's rows and x.
  template <Part part>
  Rows product(const Eigen::SparseMatrix<double>& matrix, const Node& node, const Eigen::VectorXd& x);
  /// Solves the node's equations with `before` as the product of what is known.
  static Rows solve(const Node& node, const Eigen::VectorXd& right, const Rows& known);

  const Eigen::SparseMatrix<double>* finest_ = nullptr;
  std::vector<Level> levels_;
  Cholesky coarsest_;
  Eigen::VectorXd coarsest_scale_;
  double reciprocal_condition_ = 1;
  std::vector<double> gathered_;
};

}  // namespace trajan
