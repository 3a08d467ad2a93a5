#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/executors/layout.h"

/// A periodic axis has the nodes 0 .. period - 1. Those before and after them, which particles near its faces see,
/// are images: they lie in tiles like any others, but what particles give to them is added to the nodes that they
/// are images of, and what these hold is copied back. Nothing else has to know that the grid repeats itself.
namespace trajan {

/// Along x, y and z; axes that the grid lacks are 0.
using TileIndex = std::array<std::int32_t, 3>;

/// Cells of a window, or nodes counted from a tile's first one, along each axis, both ends included.
struct CellRange {
  TileIndex lowest{}, highest{};
  auto operator<=>(const CellRange&) const = default;
};

/// Indices of some tiles along an axis: those of three tiles' nodes, which the last tile of a period, not whole,
/// may make four.
struct TilesAlong {
  std::array<std::int32_t, 4> tiles{};
  int count = 0;
  const std::int32_t* begin() const { return tiles.data(); }
  const std::int32_t* end() const { return begin() + count; }
};

/// Cells after which the grid repeats itself along each axis; 0: it does not.
struct Period {
  TileIndex cells{};

  bool any() const { return cells != TileIndex{}; }
  /// Of a node or an image along an axis.
  std::int64_t original(std::int64_t node, std::size_t axis) const {
    return cells[axis] > 0 ? (node % cells[axis] + cells[axis]) % cells[axis] : node;
  }
  /// Tiles of the nodes from .. to, counted from the first one of the tile `at`, or of those that they are images
  /// of.
  TilesAlong originals(const Layout& layout, const TileIndex& at, std::size_t axis, int from, int to) const;
  /// Whether there are images among a tile's nodes.
  bool has_images(const Layout& layout, const TileIndex& at, const CellRange& nodes) const;
};

/// Where the values of a node begin, and those of an image of it.
struct NodeImage {
  std::size_t node, image;
};

struct NodeImages {
  std::vector<NodeImage> all;
  std::vector<std::size_t> first = {0};  ///< by tile, one more than there are tiles
};

}  // namespace trajan
