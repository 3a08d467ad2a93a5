#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/executors/tiles.h"
#include "solver/model/model.h"

namespace trajan {

struct BodyParticles;

/// A particle's place in memory.
struct Slot {
  std::uint32_t body = 0;
  std::uint32_t index = 0;
};

/// Surface loads ride on carrier particles: a force is distributed to the nodes of its carrier's cell with
/// the multilinear polynomials of that cell, evaluated at the point, so that resultant and moment are exact
/// wherever the point is, and only nodes with mass are loaded.
class Loads {
 public:
  Loads(const Model& model, bool total_lagrangian);
  bool none() const { return model_.surface_loads.empty() && model_.body_loads.empty(); }

  /// Finds the carriers after particles have been sorted.
  void bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles);
  /// Sets the bodies' accelerations of this time.
  void accelerate(std::vector<BodyParticles>& bodies, double time) const;
  /// Adds the surface loads of this time to the windows of the carriers' tiles.
  void add_to(Tiles& tiles, const std::vector<BodyParticles>& bodies, double time) const;
  /// Moves the points as their carriers move, and around them as the velocities for gradients say; to be
  /// called before the particles move. A node that few particles just reach is fast without bound after the
  /// step's forces: the carrier hardly feels it, but a polynomial that is continued to the point would.
  void advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift);

  /// Positions of the points, for checkpoints: x, y, z of one after the other.
  std::vector<double>& positions() { return positions_; }

 private:
  /// The carrier's cell by its first node in its tile's window, and the polynomials of the cell's nodes.
  struct Stencil {
    const Tile* tile;
    int node;
    std::array<double, 8> of_carrier;
    std::array<double, 8> of_point;
  };
  Stencil stencil(const Tiles& tiles, const std::vector<BodyParticles>& bodies, std::size_t point) const;

  /// The cell's node of this index, from its first one.
  int corner(const Layout& layout, int n) const;

  const Model& model_;
  int axes_;  ///< of the grid
  bool total_lagrangian_;
  std::vector<double> positions_;
  std::vector<Slot> carriers_;
  std::vector<std::uint32_t> tiles_;  ///< of the carriers
};

/// Finds where particles are now. `numbers` are of all bodies, in any order.
std::vector<Slot> find_slots(const std::vector<BodyParticles>& bodies, const Model& model,
                             const std::vector<std::int64_t>& numbers);

}  // namespace trajan
