#include <algorithm>

#include "solver/executors/tiles.h"

namespace trajan {
namespace {

/// Calls of(node) for all in a range, x fastest.
template <class Of>
void for_each_node(const CellRange& nodes, Of&& of) {
  TileIndex at;
  for (at[2] = nodes.lowest[2]; at[2] <= nodes.highest[2]; ++at[2])
    for (at[1] = nodes.lowest[1]; at[1] <= nodes.highest[1]; ++at[1])
      for (at[0] = nodes.lowest[0]; at[0] <= nodes.highest[0]; ++at[0]) of(at);
}

/// What belongs to tiles, in any order, put in theirs.
NodeImages in_order(std::vector<std::pair<std::uint32_t, NodeImage>>& of_tiles, std::size_t tiles) {
  std::ranges::stable_sort(of_tiles, {}, &std::pair<std::uint32_t, NodeImage>::first);
  NodeImages images;
  images.first.assign(tiles + 1, 0);
  for (const auto& [tile, image] : of_tiles) {
    images.all.push_back(image);
    ++images.first[tile + 1];
  }
  for (std::size_t t = 0; t < tiles; ++t) images.first[t + 1] += images.first[t];
  return images;
}

}  // namespace

TilesAlong Period::originals(const Layout& layout, const TileIndex& at, std::size_t axis, int from, int to) const {
  TilesAlong along;
  const std::int64_t first = std::int64_t{at[axis]} * layout.side;
  for (int node = from; node <= to; ++node) {
    const auto tile = static_cast<std::int32_t>(original(first + node, axis) >> layout.tile_bits);
    if (std::find(along.begin(), along.end(), tile) == along.end())
      along.tiles[static_cast<std::size_t>(along.count++)] = tile;
  }
  return along;
}

bool Period::has_images(const Layout& layout, const TileIndex& at, const CellRange& nodes) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t first = std::int64_t{at[axis]} * layout.side;
    if (cells[axis] > 0 && (first + nodes.lowest[axis] < 0 || first + nodes.highest[axis] >= cells[axis]))
      return true;
  }
  return false;
}

/// Adds the tiles of the nodes whose images an occupied tile's particles can reach.
void Tiles::add_originals(const OccupiedTile& tile, std::vector<TilePlace>& reached) const {
  const CellRange nodes = nodes_reached(tile.cells);
  TilesAlong along[3] = {{{}, 1}, {{}, 1}, {{}, 1}};
  for (int axis = 0; axis < layout_.dimensions; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    along[axis] = period_.originals(layout_, tile.at, a, nodes.lowest[a], nodes.highest[a]);
  }
  for (const std::int32_t z : along[2])
    for (const std::int32_t y : along[1])
      for (const std::int32_t x : along[0]) reached.push_back({{x, y, z}, tile.field});
}

Tiles::Owner Tiles::owner(const Tile& tile, const TileIndex& node) const {
  TileIndex at{};
  Owner owner{0, 0};
  for (int axis = 0; axis < layout_.dimensions; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const std::int64_t of_grid = period_.original(std::int64_t{tile.at[a]} * layout_.side + node[a], a);
    at[a] = static_cast<std::int32_t>(of_grid >> layout_.tile_bits);
    owner.node += static_cast<int>(of_grid & (layout_.side - 1)) * layout_.tile_stride(axis);
  }
  owner.tile = find(at, tile.field);
  return owner;
}

/// Gives every tile whose nodes have images in the windows of occupied ones a window to fold them into.
void Tiles::find_folded() {
  std::vector<std::pair<std::uint32_t, NodeImage>> folded;
  const std::size_t occupied = windows_;
  std::vector<std::uint32_t> tile_of(occupied);
  for (std::uint32_t t = 0; t < tiles_.size(); ++t)
    if (tiles_[t].window >= 0) tile_of[static_cast<std::size_t>(tiles_[t].window)] = t;
  const auto place = [&](const Tile& tile, const TileIndex& node) {
    int at = 0;
    for (int axis = 0; axis < layout_.dimensions; ++axis)
      at += (node[static_cast<std::size_t>(axis)] + layout_.below) * layout_.window_stride(axis);
    return window(tile) + static_cast<std::size_t>(at);
  };
  for (const std::uint32_t t : tile_of) {
    const Tile& tile = tiles_[t];
    const CellRange nodes = nodes_reached(tile.cells);
    if (!period_.has_images(layout_, tile.at, nodes)) continue;
    for_each_node(nodes, [&](const TileIndex& node) {
      if (!period_.has_images(layout_, tile.at, {node, node})) return;
      const Owner of = owner(tile, node);
      Tile& owning = tiles_[static_cast<std::size_t>(of.tile)];
      if (owning.window < 0) owning.window = static_cast<std::int32_t>(windows_++);
      TileIndex in_tile{};
      for (int axis = 0, rest = of.node; axis < layout_.dimensions; ++axis, rest >>= layout_.tile_bits)
        in_tile[static_cast<std::size_t>(axis)] = rest & (layout_.side - 1);
      folded.emplace_back(of.tile, NodeImage{place(owning, in_tile), place(tile, node)});
    });
  }
  folded_ = in_order(folded, tiles_.size());
}

void Tiles::find_copied() {
  std::vector<std::pair<std::uint32_t, NodeImage>> copied;
  CellRange all;
  for (int axis = 0; axis < layout_.dimensions; ++axis)
    all.highest[static_cast<std::size_t>(axis)] = layout_.side - 1;
  for (std::uint32_t t = 0; t < tiles_.size(); ++t) {
    const Tile& tile = tiles_[t];
    if (!period_.has_images(layout_, tile.at, all)) continue;
    int n = -1;
    for_each_node(all, [&](const TileIndex& node) {
      ++n;
      if (!period_.has_images(layout_, tile.at, {node, node})) return;
      const Owner of = owner(tile, node);
      if (of.tile < 0) return;
      copied.emplace_back(
          t, NodeImage{static_cast<std::size_t>(of.tile) * node_size() + static_cast<std::size_t>(of.node),
                       t * node_size() + static_cast<std::size_t>(n)});
    });
  }
  copied_ = in_order(copied, tiles_.size());
}

void Tiles::fold_images(std::size_t tile) {
  for (std::size_t i = folded_.first[tile]; i < folded_.first[tile + 1]; ++i) {
    double *node = &sums_[folded_.all[i].node], *image = &sums_[folded_.all[i].image];
    for (int q = 0; q < sum_quantities_; ++q, node += layout_.window_nodes, image += layout_.window_nodes) {
      *node += *image;
      *image = 0;
    }
  }
}

void Tiles::copy_to_images(std::size_t tile) {
  for (std::size_t i = copied_.first[tile]; i < copied_.first[tile + 1]; ++i) {
    const double* node = &nodes_[copied_.all[i].node];
    double* image = &nodes_[copied_.all[i].image];
    for (int q = 0; q < node_quantities_; ++q, node += tile_nodes, image += tile_nodes) *image = *node;
  }
}

}  // namespace trajan
