#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <deque>
#include <vector>

#include "solver/executors/thread_pool.h"
#include "solver/implicit/cholesky.h"
#include "solver/implicit/coarsening.h"

namespace trajan {

/// A symmetric positive definite approximation of a matrix's inverse, whose quality hardly depends on the number
/// of cells: geometric multigrid on the background grid (Hackbusch 1985; Tatebe 1993 as a preconditioner). A
/// V-cycle has one sweep of Gauss and Seidel over the nodes forwards before the coarser grid's correction and one
/// backwards after it; the coarsest grid has a Cholesky factor.
///
/// The nodes of a grid are cut into slabs that have entries in common with their neighbours alone. A sweep
/// forwards goes through the slabs of even number, then through the others; backwards the other way round. Threads
/// share the slabs of a kind, so that bits do not depend on their number: with 40^3 cells two threads take 0.63 of
/// the time of one, in as many cycles as without slabs. Conditions that tie far nodes together leave few slabs.
class Multigrid {
 public:
  explicit Multigrid(ThreadPool& pool) : pool_(pool), gathered_(static_cast<std::size_t>(pool.size())) {}
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
    bool alike;                    ///< all have entries in the same columns
    int below;                     ///< then: entries of each in columns before the node's own
    int before_slab, to_slab_end;  ///< then: and in columns before those of its slab, and before their end
    std::array<std::array<double, 3>, 3> inverse;
  };
  struct Slab {
    std::size_t begin, end;  ///< nodes
    int first, last;         ///< columns, and where they end
    bool odd;
  };
  /// Some nodes of one slab, of which no other matters.
  struct Piece {
    std::size_t slab, begin, end;
  };
  struct Level {
    Eigen::SparseMatrix<double> matrix;  ///< of coarser grids
    std::vector<Node> nodes;
    std::vector<Slab> slabs;
    std::vector<Piece> pieces;
    bool large = false;                        ///< enough for several threads
    Interpolation interpolation, restriction;  ///< from the next level, and to it
    Eigen::VectorXd rest, right, answer;
  };
  /// Which entries of a row: those of nodes that a sweep forwards visits before, or after, the row's own.
  enum class Part { whole, before_node, after_node };
  const Eigen::SparseMatrix<double>& matrix(std::size_t level) const {
    return level == 0 ? *finest_ : levels_[level].matrix;
  }
  bool find_nodes(std::size_t level, const Places& places);
  void find_slabs(std::size_t level);
  bool factorize_coarsest(Eigen::SparseMatrix<double> matrix);
  void cycle(std::size_t level, const Eigen::VectorXd& r, Eigen::VectorXd& z);
  /// Solves the equations of a slab's nodes, one after the other, for z; backwards: for its change.
  void sweep_forwards(std::size_t level, const Slab& slab, const Eigen::VectorXd& r, Eigen::VectorXd& z,
                      double* gathered) const;
  void sweep_backwards(std::size_t level, const Slab& slab, const Eigen::VectorXd& r, Eigen::VectorXd& z,
                       double* gathered) const;
  /// Of the node's rows and x.
  template <Part part>
  static Rows product(const Eigen::SparseMatrix<double>& matrix, const Node& node, const Slab& slab,
                      const Eigen::VectorXd& x, double* gathered);
  /// Solves the node's equations with `before` as the product of what is known.
  static Rows solve(const Node& node, const Eigen::VectorXd& right, const Rows& known);
  /// Calls of(number, working memory for a row) for so many numbers, on all threads if the level is large.
  template <class Of>
  void share(const Level& level, std::size_t count, Of&& of);
  /// Calls to(row, its product with x) for all rows.
  template <class To>
  void interpolate(const Level& level, const Interpolation& by, const Eigen::VectorXd& x, To&& to);

  ThreadPool& pool_;
  const Eigen::SparseMatrix<double>* finest_ = nullptr;
  std::deque<Level> levels_;  ///< stay where they are: Eigen's matrices do not move, they are copied
  Cholesky coarsest_;
  Eigen::VectorXd coarsest_scale_;
  double reciprocal_condition_ = 1;
  std::vector<std::vector<double>> gathered_;  ///< of each thread
};

}  // namespace trajan
