#pragma once

#include <cstddef>

/// The background grid is cut into tiles of 64 cells: 64, 8 x 8 or 4 x 4 x 4. Only tiles near material
/// exist. A tile owns the nodes at the lower corners of its cells. What its particles need of the grid, and
/// what they give to it, is its window: the nodes that they can reach from its own cells and, if particles
/// drift, from a margin of one cell around them.
///
///     cells of a window along an axis: 1 .. side, the tile's own, and in the margin 0 and side + 1
///     nodes of a window along an axis: 0 .. window_side - 1, of which the tile owns below .. below + side - 1
///
/// Cell c of a window begins at the tile's node c - 1, or half a cell above it (`Reach`).
namespace trajan {

inline constexpr int tile_nodes = 64;
inline constexpr int most_neighbours = 27;  ///< the tile itself included

/// How far particles may drift out of their tile before they must be put into another. Where they stay in their
/// cells windows have half to a third of the nodes without a margin: by TLMPM in space 49 -> 40 ns per particle
/// and step with linear functions, in floats 29.5 -> 21.5.
enum class Margin : unsigned char { none, one_cell };

/// Which nodes particles reach at most, and by that which cells they belong to.
enum class Reach : unsigned char {
  cell,       ///< those of their cell
  staggered,  ///< the nearest one and one more on each side: cells lie half a cell above those of the grid
  wide        ///< those of their cell and one more on each side
};

/// Where cells begin, from the node that they are counted by. Particles are often laid out in the middle between
/// two nodes, up to rounding: staggered cells begin just before it, so that a tile has all of them or none.
constexpr double begin_of_cells(Reach reach) { return reach == Reach::staggered ? 0.5 - 0x1p-40 : 0; }

/// Nodes that particles reach beyond two, the one that their cell is counted by and the next one, along an axis.
constexpr int more_below(Reach reach) { return reach == Reach::wide ? 1 : 0; }
constexpr int more_above(Reach reach) { return reach == Reach::cell ? 0 : 1; }

struct Layout {
  int dimensions;
  Reach reach;
  Margin margin;
  int side;         ///< cells of a tile along an axis
  int tile_bits;    ///< its binary logarithm
  int below;        ///< nodes of a window below the tile's first one, along an axis
  int above;        ///< nodes of a window above the tile's last one, along an axis
  int window_side;  ///< nodes of a window along an axis
  /// Doubles of one quantity in a window, in whole cache lines, with at least three to spare: rows of nodes
  /// are read and written four at a time.
  int window_nodes;
  int neighbours;  ///< 3 to the power of dimensions

  constexpr Layout(int axes, Reach of_particles, Margin around = Margin::one_cell)
      : dimensions(axes),
        reach(of_particles),
        margin(around),
        side(axes == 1   ? 64
             : axes == 2 ? 8
                         : 4),
        tile_bits(6 / axes),
        below(more_below(of_particles) + (around == Margin::one_cell ? 1 : 0)),
        above(1 + more_above(of_particles) + (around == Margin::one_cell ? 1 : 0)),
        window_side(side + below + above),
        window_nodes((power(window_side, axes) + 3 + 7) / 8 * 8),
        neighbours(power(3, axes)) {}

  /// Where a quantity's array begins among those of a window.
  constexpr std::ptrdiff_t window_array(int quantity) const { return std::ptrdiff_t{quantity} * window_nodes; }
  /// Distance in memory of neighbouring nodes along an axis.
  constexpr int tile_stride(int axis) const { return power(side, axis); }
  constexpr int window_stride(int axis) const { return power(window_side, axis); }

 private:
  static constexpr int power(int base, int exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
  }
};

/// What nodes hold is one array of nodes per quantity: mass, then vectors. So it is with what particles scatter.
enum SumVector : int {
  sum_momentum,
  sum_force,  ///< internal
  sum_load,   ///< external; only there if the scene has loads
  sum_vectors
};
enum NodeVector : int {
  node_acceleration,
  node_velocity,         ///< after the step's forces
  node_mapped_velocity,  ///< for gradients: in MUSL mapped a second time from the particles
  node_vectors,
  /// \name Only of transfers that iterate
  /// @{
  node_remainder = node_vectors,  ///< of velocity, what the particles have not been able to carry so far
  node_projected_velocity         ///< what the particles take on, where it is not the velocity itself
  /// @}
};
inline constexpr int quantity_mass = 0;
/// Index of a component of a vector among the quantities.
constexpr int quantity(int vector, int axis, int dimensions) { return 1 + vector * dimensions + axis; }
/// How many quantities the mass and so many vectors are.
constexpr int quantities(int vectors, int dimensions) { return 1 + vectors * dimensions; }
/// Where a quantity's array begins among those of a tile's nodes.
constexpr std::ptrdiff_t tile_array(int quantity) { return std::ptrdiff_t{quantity} * tile_nodes; }

}  // namespace trajan
