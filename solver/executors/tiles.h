#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/executors/aligned.h"
#include "solver/executors/tile.h"

namespace trajan {

/// Cells of a window, both ends included.
struct CellRange {
  std::int32_t lowest_x = 0, highest_x = 0, lowest_y = 0, highest_y = 0;
  auto operator<=>(const CellRange&) const = default;
};

/// Consecutive particles of one body, all in one tile.
struct BlockRange {
  std::uint32_t begin = 0;
  std::uint16_t count = 0;
  std::uint16_t body = 0;
};

/// A tile that has particles: its place in units of tiles, where in its window they may be.
struct OccupiedTile {
  std::int32_t x = 0, y = 0;
  CellRange cells;
};

struct Tile {
  std::int32_t x = 0, y = 0;
  std::array<std::int32_t, 9> around{};  ///< indices of the 3 x 3 tiles, row by row; -1: does not exist
  CellRange cells;
  std::int32_t window = -1;                       ///< index of its sums; -1: no particles
  std::uint32_t first_block = 0, last_block = 0;  ///< half-open
};

/// The part of the background grid that exists. Ordered row by row.
class Tiles {
 public:
  /// `occupied` in order; `blocks` in the order of their tiles, `blocks_of[i]` the number of those of
  /// occupied tile i. Node values and sums are not kept.
  void rebuild(std::span<const OccupiedTile> occupied, std::vector<BlockRange> blocks,
               std::span<const std::uint32_t> blocks_of, int sum_arrays);

  std::span<const Tile> tiles() const { return tiles_; }
  std::span<const BlockRange> blocks() const { return blocks_; }
  int sum_arrays() const { return sum_arrays_; }
  double* nodes(std::size_t tile) { return nodes_.data() + tile * node_value_count * tile_nodes; }
  const double* nodes(std::size_t tile) const { return nodes_.data() + tile * node_value_count * tile_nodes; }
  /// Only of a tile that has particles.
  double* sums(std::size_t tile) { return sums_.data() + window(tiles_[tile]); }
  /// Of the 3 x 3 tiles around, zeros where there is none.
  std::array<const double*, 9> nodes_around(const Tile& tile) const;
  std::array<const double*, 9> sums_around(const Tile& tile) const;
  /// Index of the tile at (x, y), -1 if it does not exist.
  std::int32_t find(std::int32_t x, std::int32_t y) const;
  /// Contiguous shares of the tiles for `threads` threads, of about equal work: threads + 1 bounds.
  std::vector<std::size_t> shares(int threads) const;
  std::size_t memory() const;

 private:
  std::size_t window(const Tile& tile) const {
    return static_cast<std::size_t>(tile.window) * static_cast<std::size_t>(sum_arrays_ * window_nodes);
  }

  std::vector<Tile> tiles_;
  std::vector<BlockRange> blocks_;
  AlignedDoubles nodes_, sums_;
  int sum_arrays_ = 0;
};

}  // namespace trajan
