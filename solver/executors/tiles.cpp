#include "solver/executors/tiles.h"

#include <algorithm>
#include <tuple>

namespace trajan {

namespace {

auto rank(const TileIndex& at) { return std::tuple(at[1] >> 3, at[0] >> 3, at[2], at[1], at[0]); }
/// Of a tile or of its place.
auto rank_with_field(const auto& tile) { return std::tuple_cat(rank(tile.at), std::tuple(tile.field)); }

}  // namespace

bool before(const TileIndex& a, const TileIndex& b) { return rank(a) < rank(b); }

CellRange Tiles::nodes_reached(const CellRange& cells) const {
  // Cell c of the window has the tile's nodes c - 1 and c.
  CellRange nodes;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout_.dimensions); ++axis) {
    nodes.lowest[axis] = cells.lowest[axis] - 1 - more_below(layout_.reach);
    nodes.highest[axis] = cells.highest[axis] + more_above(layout_.reach);
  }
  return nodes;
}

/// Adds the tiles that own nodes of an occupied tile's window which its particles can reach.
void Tiles::add_reached(const OccupiedTile& tile, std::vector<TilePlace>& reached) const {
  const CellRange nodes = nodes_reached(tile.cells);
  TileIndex down{}, up{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(layout_.dimensions); ++axis) {
    down[axis] = nodes.lowest[axis] < 0 ? -1 : 0;
    up[axis] = nodes.highest[axis] >= layout_.side ? 1 : 0;
  }
  for (int z = down[2]; z <= up[2]; ++z)
    for (int y = down[1]; y <= up[1]; ++y)
      for (int x = down[0]; x <= up[0]; ++x)
        reached.push_back({{tile.at[0] + x, tile.at[1] + y, tile.at[2] + z}, tile.field});
  if (period_.has_images(layout_, tile.at, nodes)) add_originals(tile, reached);
}

void Tiles::find_neighbours(Tile& tile) const {
  for (int n = 0; n < layout_.neighbours; ++n) {
    TileIndex at = tile.at;
    for (int axis = 0, rest = n; axis < layout_.dimensions; ++axis, rest /= 3) at[axis] += rest % 3 - 1;
    tile.around[n] = find(at, tile.field);
  }
}

void Tiles::rebuild(std::span<const OccupiedTile> occupied, std::vector<BlockRange> blocks,
                    std::span<const std::uint32_t> blocks_of) {
  std::vector<TilePlace> reached;
  for (const OccupiedTile& tile : occupied) add_reached(tile, reached);
  const auto by_rank = [](const TilePlace& tile) { return rank_with_field(tile); };
  std::ranges::sort(reached, {}, by_rank);
  // Not of std::ranges: Clang 14 cannot compile the subrange that libstdc++ 12 returns.
  const auto same = [&](const TilePlace& a, const TilePlace& b) { return by_rank(a) == by_rank(b); };
  reached.erase(std::unique(reached.begin(), reached.end(), same), reached.end());
  tiles_ = std::vector<Tile>(reached.size());
  for (std::size_t t = 0; t < reached.size(); ++t) {
    tiles_[t].at = reached[t].at;
    tiles_[t].field = reached[t].field;
  }

  blocks_ = std::move(blocks);
  std::uint32_t block = 0;
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    Tile& tile = tiles_[static_cast<std::size_t>(find(occupied[i].at, occupied[i].field))];
    tile.cells = occupied[i].cells;
    tile.window = static_cast<std::int32_t>(i);
    tile.first_block = block;
    block += blocks_of[i];
    tile.last_block = block;
  }
  for (Tile& tile : tiles_) find_neighbours(tile);
  windows_ = occupied.size();
  if (period_.any()) {
    find_folded();
    find_copied();
  }

  nodes_.assign(tiles_.size() * node_size(), 0.0);
  nothing_.assign(std::max(node_size(), window_size()), 0.0);
}

void Tiles::make_windows() { sums_.assign(windows_ * window_size(), 0.0); }

void Tiles::make_windows(const WindowsOfTiles& windows) {
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) tiles_[tile].window = windows.of_tile[tile];
  windows_ = static_cast<std::size_t>(windows.count);
  make_windows();
}

Neighbours Tiles::nodes_around(const Tile& tile) const {
  Neighbours around{};
  for (int n = 0; n < layout_.neighbours; ++n)
    around[n] = tile.around[n] < 0 ? nothing_.data() : nodes(static_cast<std::size_t>(tile.around[n]));
  return around;
}

Neighbours Tiles::sums_around(const Tile& tile) const {
  Neighbours around{};
  for (int n = 0; n < layout_.neighbours; ++n) {
    const Tile* other = tile.around[n] < 0 ? nullptr : &tiles_[static_cast<std::size_t>(tile.around[n])];
    around[n] = other && other->window >= 0 ? sums_.data() + window(*other) : nothing_.data();
  }
  return around;
}

std::int32_t Tiles::find(const TileIndex& at, std::uint32_t field) const {
  const auto wanted = rank_with_field(TilePlace{at, field});
  const auto by_rank = [](const Tile& tile) { return rank_with_field(tile); };
  const auto found = std::ranges::lower_bound(tiles_, wanted, {}, by_rank);
  if (found == tiles_.end() || by_rank(*found) != wanted) return -1;
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
         (folded_.all.capacity() + copied_.all.capacity()) * sizeof(NodeImage) +
         (nodes_.capacity() + sums_.capacity() + nothing_.capacity()) * sizeof(double);
}

}  // namespace trajan
