#pragma once

/// The background grid is cut into square tiles; only tiles near material exist. A tile owns the nodes at
/// the lower left corners of its cells. What its particles need of the grid, and what they give to it, is
/// its window: the nodes of its own cells and of a margin of one cell around them, so that particles may
/// drift up to one cell out of their tile before they must be put into another.
///
///     cells of a window: 0 .. 9, of which 1 .. 8 are the tile's own
///     nodes of a window: 0 .. 10, of which the tile owns 1 .. 8; node (i, j) at index 11 j + i
namespace trajan {

inline constexpr int tile_side = 8;
inline constexpr int tile_nodes = tile_side * tile_side;
inline constexpr int window_side = tile_side + 3;
/// Doubles of one quantity in a window: 11 x 11 nodes, padded to whole cache lines.
inline constexpr int window_nodes = 128;

/// What particles scatter, one array of nodes per quantity.
enum Sum : int {
  sum_mass,
  sum_momentum_x,
  sum_momentum_y,
  sum_force_x,  ///< internal
  sum_force_y,
  sum_load_x,  ///< external; only there if the scene has loads
  sum_load_y,
  sum_count
};
inline constexpr int sums_without_loads = sum_load_x;

/// What nodes hold for particles to gather, one array of nodes per quantity.
enum NodeValue : int {
  node_mass,
  node_acceleration_x,
  node_acceleration_y,
  node_velocity_x,  ///< after the step's forces
  node_velocity_y,
  node_mapped_velocity_x,  ///< for gradients: in MUSL mapped a second time from the particles
  node_mapped_velocity_y,
  node_value_count
};

/// Bilinear interpolation in the cell whose lower left node has index k:
/// base[k] + fx dx[k] + fy (dy[k] + fx dxy[k]), exact for a uniform field.
struct alignas(64) WindowValue {
  double base[window_nodes];
  double dx[window_nodes];
  double dy[window_nodes];
  double dxy[window_nodes];
};
struct Window {
  WindowValue values[node_value_count];
};

}  // namespace trajan
