#include "solver/executors/tiles.h"

#include <algorithm>
#include <tuple>

namespace trajan {
namespace {

/// Values of a tile that does not exist.
alignas(64) constexpr double nothing[sum_count * window_nodes] = {};
static_assert(node_value_count * tile_nodes <= sum_count * window_nodes);

bool before(const Tile& a, const Tile& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); }

/// The tiles that own nodes of an occupied tile's window which its particles can reach.
void add_reached(const OccupiedTile& tile, std::vector<Tile>& out) {
  // Window nodes 1 .. 8 are the tile's own; cell c touches nodes c and c + 1.
  const int left = tile.cells.lowest_x < 1 ? -1 : 0, right = tile.cells.highest_x + 1 > tile_side ? 1 : 0;
  const int down = tile.cells.lowest_y < 1 ? -1 : 0, up = tile.cells.highest_y + 1 > tile_side ? 1 : 0;
  for (int dy = down; dy <= up; ++dy)
    for (int dx = left; dx <= right; ++dx) {
      Tile reached;
      reached.x = tile.x + dx;
      reached.y = tile.y + dy;
      out.push_back(reached);
    }
}

}  // namespace

void Tiles::rebuild(std::span<const OccupiedTile> occupied, std::vector<BlockRange> blocks,
                    std::span<const std::uint32_t> blocks_of, int sum_arrays) {
  tiles_.clear();
  for (const OccupiedTile& tile : occupied) add_reached(tile, tiles_);
  std::sort(tiles_.begin(), tiles_.end(), before);
  const auto same = [](const Tile& a, const Tile& b) { return a.x == b.x && a.y == b.y; };
  tiles_.erase(std::unique(tiles_.begin(), tiles_.end(), same), tiles_.end());
  tiles_.shrink_to_fit();

  blocks_ = std::move(blocks);
  std::uint32_t block = 0;
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    Tile& tile = tiles_[static_cast<std::size_t>(find(occupied[i].x, occupied[i].y))];
    tile.cells = occupied[i].cells;
    tile.window = static_cast<std::int32_t>(i);
    tile.first_block = block;
    block += blocks_of[i];
    tile.last_block = block;
  }
  for (Tile& tile : tiles_)
    for (int n = 0; n < 9; ++n) tile.around[n] = find(tile.x + n % 3 - 1, tile.y + n / 3 - 1);

  sum_arrays_ = sum_arrays;
  nodes_.assign(tiles_.size() * node_value_count * tile_nodes, 0.0);
  sums_.assign(occupied.size() * sum_arrays * window_nodes, 0.0);
}

std::array<const double*, 9> Tiles::nodes_around(const Tile& tile) const {
  std::array<const double*, 9> around;
  for (int n = 0; n < 9; ++n)
    around[n] = tile.around[n] < 0 ? nothing : nodes(static_cast<std::size_t>(tile.around[n]));
  return around;
}

std::array<const double*, 9> Tiles::sums_around(const Tile& tile) const {
  std::array<const double*, 9> around;
  for (int n = 0; n < 9; ++n) {
    const Tile* other = tile.around[n] < 0 ? nullptr : &tiles_[static_cast<std::size_t>(tile.around[n])];
    around[n] = other && other->window >= 0 ? sums_.data() + window(*other) : nothing;
  }
  return around;
}

std::int32_t Tiles::find(std::int32_t x, std::int32_t y) const {
  Tile wanted;
  wanted.x = x;
  wanted.y = y;
  const auto found = std::lower_bound(tiles_.begin(), tiles_.end(), wanted, before);
  if (found == tiles_.end() || found->x != x || found->y != y) return -1;
  return static_cast<std::int32_t>(found - tiles_.begin());
}

std::vector<std::size_t> Tiles::shares(int threads) const {
  // A tile costs about as much as 64 particles on top of its own.
  const auto cost = [this](const Tile& tile) {
    std::size_t sum = 64;
    for (std::uint32_t b = tile.first_block; b < tile.last_block; ++b) sum += blocks_[b].count;
    return sum;
  };
  std::size_t total = 0;
  for (const Tile& tile : tiles_) total += cost(tile);
  std::vector<std::size_t> bounds{0};
  std::size_t sum = 0;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    sum += cost(tiles_[i]);
    while (bounds.size() < static_cast<std::size_t>(threads) && sum * threads >= total * bounds.size())
      bounds.push_back(i + 1);
  }
  bounds.resize(static_cast<std::size_t>(threads) + 1, tiles_.size());
  return bounds;
}

std::size_t Tiles::memory() const {
  return tiles_.capacity() * sizeof(Tile) + blocks_.capacity() * sizeof(BlockRange) +
         (nodes_.capacity() + sums_.capacity()) * sizeof(double);
}

}  // namespace trajan
