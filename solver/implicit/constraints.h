#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/implicit/assembly.h"
#include "solver/implicit/discretization.h"
#include "solver/implicit/places.h"

namespace trajan {

/// What boundary conditions say about the displacements of a step, solved for as many unknowns: u = expand() q +
/// given() with unknowns q that are free. Exact, without penalties or multipliers, and symmetric matrices stay
/// positive definite.
class Constraints : private DisplacementConstraints, private MeanConstraints {
 public:
  /// Of displacements between two times. Throws FormulaNotFinite.
  Constraints(const Discretization& on, Executor& executor, double from, double to);

  const SparseMatrix& expand() const { return expand_; }
  const Eigen::VectorXd& given() const { return given_; }
  /// Of the free unknowns.
  Places places() const;
  /// Whether nothing is prescribed but zero.
  bool homogeneous() const { return homogeneous_; }

  /// sum of coefficient times unknown = value
  struct Row {
    std::vector<std::pair<std::uint32_t, double>> terms;
    double value = 0;
    std::size_t condition = 0;  ///< that asks for it
    bool of_node = false;       ///< not of a mean
  };
  /// As they were asked for.
  const std::vector<Row>& rows() const { return rows_; }
  /// Adds forces that keep unknowns where they must be, for a time, to the impulses of the conditions: on a node
  /// that is held all of them to the condition that holds it, on others to those of the means that they are in, by
  /// weight.
  void add_reactions(const Eigen::VectorXd& forces, double time, std::span<Reaction> reactions) const;

 private:
  void prescribe(std::size_t condition, std::size_t tile, int node, int axis, double displacement) override;
  void prescribe_mean(std::size_t condition, std::span<const SurfaceNode> nodes, int axis,
                      double displacement) override;
  void eliminate(const Row& row);
  void make_expansion();

  const Discretization& on_;
  std::vector<Row> rows_;
  /// unknown = sum of terms + value, by elimination; of each unknown which one it is, -1: it is free.
  std::vector<Row> eliminated_;
  std::vector<std::int32_t> which_;
  SparseMatrix expand_;
  Eigen::VectorXd given_;
  bool homogeneous_ = true;
};

}  // namespace trajan
