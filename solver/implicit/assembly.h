#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "solver/implicit/discretization.h"
#include "solver/implicit/ghost_penalty.h"

namespace trajan {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// A vector's numbers.
inline std::span<const double> span_of(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}
inline std::span<double> span_of(Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

/// Sums over particles to nodes: matrices of unknowns() rows and columns, all with the same pattern, and vectors.
/// Each column is summed by one thread in the order of particles, so that bits do not depend on threads.
class Assembly {
 public:
  Assembly(const Discretization& on, const GhostPenalty& ghost, ThreadPool& pool);

  /// The derivative of forces by displacements, from tangents of particles and the ghost penalty. In the pattern's
  /// rows and columns of nodes other terms may be added.
  void stiffness(const std::vector<double>& tangents, SparseMatrix& out) const;
  /// Masses of particles between their nodes; lumped: row sums on the diagonal.
  void mass(bool lumped, SparseMatrix& out) const;
  /// Adds what particles' forces give to the nodes, and the ghost penalty's forces at a displacement.
  void add_forces(const std::vector<double>& forces, std::span<const double> displacement,
                  std::span<double> out) const;

 private:
  struct Incidence {
    std::uint32_t element;  ///< particle or difference
    std::uint32_t place;    ///< of the node in it
  };
  void find_neighbours();
  /// A matrix of zeros with the pattern of all: for each node a column of blocks, one of each neighbour.
  void begin(SparseMatrix& out) const;
  template <class Column>
  void for_each_column(Column&& of) const;

  const Discretization& on_;
  const GhostPenalty& ghost_;
  ThreadPool& pool_;
  std::vector<std::size_t> first_incidence_, first_ghost_;  ///< by node
  std::vector<Incidence> incidences_, ghosts_;
  /// Of each node those that share a particle or a difference with it, itself among them, in order.
  std::vector<std::size_t> first_neighbour_;
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace trajan
