#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/executors/aligned.h"
#include "solver/executors/layout.h"
#include "solver/executors/node_images.h"

namespace trajan {

/// Consecutive particles of one body, all in one tile.
struct BlockRange {
  std::uint32_t begin = 0;
  std::uint16_t count = 0;
  std::uint16_t body = 0;
};

/// Where a tile is, in units of tiles, and the velocity field that it belongs to.
struct TilePlace {
  TileIndex at{};
  std::uint32_t field = 0;
};

/// A tile that has particles: its place in units of tiles, the velocity field that they share, where in its window
/// they may be.
struct OccupiedTile {
  TileIndex at{};
  std::uint32_t field = 0;
  CellRange cells;
};

struct Tile {
  TileIndex at{};
  std::uint32_t field = 0;
  /// Indices of the field's tiles around, x fastest, the tile itself in the middle; -1: does not exist.
  std::array<std::int32_t, most_neighbours> around{};
  CellRange cells;
  std::int32_t window = -1;                       ///< index of its sums; -1: nothing is given to it
  std::uint32_t first_block = 0, last_block = 0;  ///< half-open
};

/// Which window each tile has, -1: none; and how many there are.
struct WindowsOfTiles {
  std::vector<std::int32_t> of_tile;
  std::int32_t count = 0;
};

/// Row by row and plane by plane within towers of 8 x 8 tiles, one tower after the other: what the tiles around
/// one hold stays in the cache while it is needed. In space, for 4 million particles 56 -> 49.5 ns per particle
/// and step with linear functions.
bool before(const TileIndex& a, const TileIndex& b);

using Neighbours = std::array<const double*, most_neighbours>;

/// The part of the background grid that exists, in order. Each velocity field has tiles of its own: those in the
/// same place follow each other.
class Tiles {
 public:
  /// `node_quantities`: how many arrays a tile's nodes have; `sum_quantities`: how many a window has.
  Tiles(const Layout& layout, int node_quantities, int sum_quantities, const Period& period = {})
      : layout_(layout), node_quantities_(node_quantities), sum_quantities_(sum_quantities), period_(period) {}

  /// `occupied` in order; `blocks` in the order of their tiles, `blocks_of[i]` the number of those of
  /// occupied tile i. Node values are not kept, and there are no sums until windows are made.
  void rebuild(std::span<const OccupiedTile> occupied, std::vector<BlockRange> blocks,
               std::span<const std::uint32_t> blocks_of);
  /// A window for every tile that has particles, or nodes with images in such windows.
  void make_windows();
  /// Those of these tiles, which may share them if none is needed while another has it. Not of a periodic grid.
  void make_windows(const WindowsOfTiles& windows);

  const Layout& layout() const { return layout_; }
  /// Cells after which the grid repeats itself along an axis; 0: it does not.
  int period(int axis) const { return period_.cells[static_cast<std::size_t>(axis)]; }
  const Period& period() const { return period_; }
  std::span<const Tile> tiles() const { return tiles_; }
  std::span<const BlockRange> blocks() const { return blocks_; }
  int sum_quantities() const { return sum_quantities_; }
  double* nodes(std::size_t tile) { return nodes_.data() + tile * node_size(); }
  const double* nodes(std::size_t tile) const { return nodes_.data() + tile * node_size(); }
  /// Only of a tile that has a window.
  double* sums(std::size_t tile) { return sums_.data() + window(tiles_[tile]); }
  /// Of the tiles around, zeros where there is none.
  Neighbours nodes_around(const Tile& tile) const;
  Neighbours sums_around(const Tile& tile) const;
  /// \name Of a periodic grid. Tiles may be given in any order, and at the same time.
  /// @{
  /// Moves what windows hold of images of the tile's nodes to the nodes' own sums.
  void fold_images(std::size_t tile);
  /// Gives images in the tile the values of their nodes.
  void copy_to_images(std::size_t tile);
  /// Which tile (-1: it does not exist), and which of its nodes.
  struct Owner {
    std::int32_t tile;
    int node;
  };
  /// Of a node, counted from a tile's first one, or of the one that it is an image of.
  Owner owner(const Tile& tile, const TileIndex& node) const;
  /// @}
  /// Calls of(tile) for the field's tiles whose nodes, or images of them, lie in a tile or in its neighbours.
  template <class Of>
  void for_each_around(const Tile& tile, Of&& of) const {
    if (!period_.any()) {
      for (int n = 0; n < layout_.neighbours; ++n)
        if (tile.around[n] >= 0) of(tiles_[static_cast<std::size_t>(tile.around[n])]);
      return;
    }
    TilesAlong along[3] = {{{}, 1}, {{}, 1}, {{}, 1}};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout_.dimensions); ++axis)
      along[axis] = period_.originals(layout_, tile.at, axis, -layout_.side, 2 * layout_.side - 1);
    for (const std::int32_t z : along[2])
      for (const std::int32_t y : along[1])
        for (const std::int32_t x : along[0])
          if (const std::int32_t t = find({x, y, z}, tile.field); t >= 0) of(tiles_[static_cast<std::size_t>(t)]);
  }
  /// Index of a tile, -1 if it does not exist.
  std::int32_t find(const TileIndex& at, std::uint32_t field = 0) const;
  /// Contiguous shares of the tiles for `threads` threads, of about equal work: threads + 1 bounds.
  std::vector<std::size_t> shares(int threads) const;
  std::size_t memory() const;

 private:
  std::size_t node_size() const { return static_cast<std::size_t>(node_quantities_) * tile_nodes; }
  std::size_t window_size() const { return static_cast<std::size_t>(sum_quantities_) * layout_.window_nodes; }
  std::size_t window(const Tile& tile) const { return static_cast<std::size_t>(tile.window) * window_size(); }
  void add_reached(const OccupiedTile& tile, std::vector<TilePlace>& reached) const;
  void add_originals(const OccupiedTile& tile, std::vector<TilePlace>& reached) const;
  void find_neighbours(Tile& tile) const;
  /// Nodes that particles in these cells of a window see, counted from the tile's first one.
  CellRange nodes_reached(const CellRange& cells) const;
  void find_folded();
  void find_copied();

  Layout layout_;
  int node_quantities_, sum_quantities_;
  Period period_;
  std::vector<Tile> tiles_;
  std::vector<BlockRange> blocks_;
  AlignedDoubles nodes_, sums_;
  AlignedDoubles nothing_;  ///< values of a tile that does not exist
  std::size_t windows_ = 0;
  NodeImages folded_;  ///< places in sums_, by the nodes' tiles
  NodeImages copied_;  ///< places in nodes_, by the images' tiles
};

}  // namespace trajan
