#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/executors/tiles.h"
#include "solver/model/model.h"
#include "solver/surfaces/point_functions.h"

namespace trajan {

struct BodyParticles;

/// A particle's place in memory.
struct Slot {
  std::uint32_t body = 0;
  std::uint32_t index = 0;
};

/// Finds where particles are now. `numbers` are of all bodies, in any order.
std::vector<Slot> find_slots(const std::vector<BodyParticles>& bodies, const Model& model,
                             const std::vector<std::int64_t>& numbers);

/// A component of a vector by its axis.
inline double component(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// Surface points that ride on carrier particles. What they do to the grid goes to the carrier's nodes with the
/// polynomials that the shape functions are where the carrier is, evaluated at the point, so that resultant and
/// moment are exact wherever the point is, and only nodes with mass are touched.
class Riders {
 public:
  /// With `follow` the points' tangents are carried along too. `functions` live as long.
  Riders(const Model& model, std::vector<SurfacePoint> points, bool follow, const PointFunctions& functions);

  /// Stencils stay with the reference positions.
  bool total_lagrangian() const { return total_lagrangian_; }
  bool follow() const { return follow_; }
  std::size_t size() const { return points_.size(); }
  const SurfacePoint& point(std::size_t p) const { return points_[p]; }
  /// Finds the carriers after particles have been sorted.
  void bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles);
  /// Moves the points as their carriers move, and around them as the velocities for gradients say; to be
  /// called before the particles move. A node that few particles just reach is fast without bound after the
  /// step's forces: the carrier hardly feels it, but a polynomial that is continued to the point would.
  void advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift);
  /// Moves the points by displacements that the nodes hold in the place of velocities. The gradient is that of the
  /// whole motion, not of its rate in the middle.
  void displace(const Tiles& tiles, const std::vector<BodyParticles>& bodies);
  /// \name Of points that follow: what material vectors along the surface were at first and are now, and where the
  /// point is now.
  /// @{
  const double* tangent(std::size_t p, int which) const {
    return &state_[stride_ * p + 6 + 3 * static_cast<std::size_t>(which)];
  }
  const double* place(std::size_t p) const { return &state_[stride_ * p + 3]; }
  /// @}
  /// Puts a coordinate of a point where it belongs (the reference position in a total Lagrangian scheme).
  void place(std::size_t p, int axis, double coordinate) {
    state_[stride_ * p + static_cast<std::size_t>(axis)] = coordinate;
  }
  /// Outward normal times area, now, thickness included; axisymmetric: times the radius.
  Vector area(std::size_t p) const;

  /// The carrier's nodes by the first one in its tile's window, and the places from there, in cells.
  struct Stencil {
    std::uint32_t tile;
    int node;
    double of_carrier[3] = {}, of_point[3] = {};
    int below[3] = {}, above[3] = {};  ///< nodes beyond a face of the domain; less than 0: up to the face
  };
  /// A force meets internal ones, which a particle gives to all nodes that its domain reaches: its stencil is
  /// where the domain ends. Velocities are those of the carrier's place.
  enum class Of { velocity, force };
  Stencil stencil(const Tiles& tiles, const std::vector<BodyParticles>& bodies, std::size_t p,
                  Of of = Of::velocity) const;
  /// One value for each of the first corners() nodes, x fastest.
  using Values = std::array<double, most_nodes_along * most_nodes_along * most_nodes_along>;
  /// Shape functions at a place in a stencil.
  Values weights(const Stencil& stencil, const double (&place)[3]) const;
  /// Their derivatives along an axis.
  Values slopes(const Stencil& stencil, const double (&place)[3], int axis) const;
  /// The stencil's node of this index, from its first one, in a window.
  int corner(int n) const { return corners_[static_cast<std::size_t>(n)]; }
  /// Who owns a node of a tile's window: tile and node.
  struct Owner {
    std::uint32_t tile;
    int node;
  };
  Owner owner(const Tiles& tiles, std::uint32_t tile, int window_node) const;
  int corners() const { return static_cast<int>(corners_.size()); }
  const PointFunctions& functions() const { return functions_; }

  /// What changes, for checkpoints.
  std::vector<double>& state() { return state_; }

 private:
  void advect(const Tiles& tiles, const Stencil& stencil, std::size_t p, double drift);
  void turn(const double (&gradient)[3][3], std::size_t p, double drift);

  std::uint32_t tile_inside(const Tiles& tiles, const std::vector<BodyParticles>& bodies, std::size_t p) const;
  void find_corners(const Layout& layout);
  Values product(const Stencil& stencil, const double (&place)[3], int sloped) const;

  const Model& model_;
  const PointFunctions& functions_;
  int axes_;  ///< of the grid
  bool total_lagrangian_, follow_, whole_motion_ = false;
  std::vector<SurfacePoint> points_;
  std::vector<Vector> inward_;  ///< hardly into the body, in cells; zero of points without a surface
  /// By point: where stencils are evaluated; with `follow` also where it is now, and two tangents.
  std::size_t stride_;
  std::vector<double> state_;
  std::vector<Slot> carriers_;
  std::vector<std::uint32_t> tiles_;  ///< of the carriers
  std::vector<int> corners_;          ///< where a stencil's nodes are in a window, from its first one
};

}  // namespace trajan
