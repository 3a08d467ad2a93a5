#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/simulation/executor.h"

namespace trajan {

/// What particles see of the grid while they stay where shape functions are evaluated, and the nodes that any of
/// them sees, numbered. Particles are numbered in the order of the executor's blocks. A vector of nodes is one
/// array of nodes() times axes() numbers, the components of a node together.
class Discretization {
 public:
  /// At the present places of particles, which must be sorted.
  Discretization(const Model& model, Executor& executor);

  int axes() const { return axes_; }
  bool axisymmetric() const { return axisymmetric_; }
  /// Of a particle's displacement gradient (solver/schemes/law_response.h).
  int components() const { return axes_ * axes_ + (axisymmetric_ ? 1 : 0); }
  std::size_t nodes() const { return owners_.size(); }
  std::size_t unknowns() const { return nodes() * static_cast<std::size_t>(axes_); }
  std::size_t particles() const { return first_node_.size() - 1; }
  /// The first particle of a block.
  std::size_t first_particle(std::size_t block) const { return first_particle_[block]; }

  struct Particle {
    std::span<const std::uint32_t> nodes;
    const double* weights;
    const double* gradients;  ///< axes of each node
    double inverse_radius;    ///< axisymmetric, otherwise 0
  };
  Particle particle(std::size_t p) const {
    const std::size_t first = first_node_[p];
    return {{nodes_.data() + first, first_node_[p + 1] - first},
            weights_.data() + first,
            gradients_.data() + first * static_cast<std::size_t>(axes_),
            axisymmetric_ ? inverse_radii_[p] : 0.0};
  }
  double mass(std::size_t p) const { return masses_[p]; }
  /// At rest, thickness included.
  double volume(std::size_t p) const { return volumes_[p]; }
  std::uint32_t body(std::size_t p) const { return bodies_[p]; }

  /// Particles of one body that see the same nodes, where each shape function is one polynomial. There are cells
  /// only for scenes whose locking remedy asks for them.
  std::size_t cells() const { return cells_.empty() ? 0 : cells_.size() - 1; }
  std::span<const std::uint32_t> members(std::size_t cell) const {
    return {cell_particles_.data() + cells_[cell].particle, cells_[cell + 1].particle - cells_[cell].particle};
  }
  /// The first node of a cell (or their end) in a list of all cells' nodes.
  std::size_t first_node(std::size_t cell) const { return cells_[cell].node; }

  /// The number of a tile's node, -1 if no particle sees it.
  std::int32_t number(std::size_t tile, int node) const {
    return numbers_[tile * static_cast<std::size_t>(tile_nodes) + static_cast<std::size_t>(node)];
  }
  struct Owner {
    std::uint32_t tile;
    std::int32_t node;
  };
  Owner owner(std::size_t n) const { return owners_[n]; }
  /// Of the grid, along each axis.
  std::array<std::int64_t, 3> grid_index(std::size_t n) const;
  /// The number of the node so many nodes away along an axis, -1 if no particle sees it.
  std::int32_t neighbour(std::size_t n, int axis, int steps) const;

 private:
  void find_stencils(const Model& model, Executor& executor);
  void find_cells();

  const Tiles& tiles_;
  int axes_;
  bool axisymmetric_;
  std::vector<std::size_t> first_particle_, first_node_;
  std::vector<std::uint32_t> nodes_, bodies_;
  std::vector<double> weights_, gradients_, masses_, volumes_, inverse_radii_;
  std::vector<std::int32_t> numbers_;  ///< by tile and node
  std::vector<Owner> owners_;          ///< by number
  struct CellBegin {
    std::size_t particle, node;
  };
  std::vector<CellBegin> cells_;  ///< and one that ends the lists
  std::vector<std::uint32_t> cell_particles_;
};

}  // namespace trajan
