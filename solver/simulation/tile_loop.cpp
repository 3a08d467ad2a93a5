#include "solver/simulation/tile_loop.h"

#include <algorithm>

namespace trajan {
namespace {

std::size_t index_of(const Tile& tile, const Tiles& tiles) {
  return static_cast<std::size_t>(&tile - tiles.tiles().data());
}

}  // namespace

void TileLoop::find_when_ready(const Tiles& tiles) {
  waits_.assign(tiles.tiles().size(), 0);
  for (std::size_t thread = 0; thread < ready_.size(); ++thread) {
    const std::size_t begin = shares_[thread], end = shares_[thread + 1];
    ready_[thread].clear();
    for (std::size_t tile = begin; tile < end; ++tile) {
      std::size_t last = tile;
      tiles.for_each_around(tiles.tiles()[tile], [&](const Tile& around) {
        const std::size_t other = index_of(around, tiles);
        if (other < begin || other >= end) waits_[tile] = 1;
        last = std::max(last, other);
      });
      if (!waits_[tile]) ready_[thread].push_back({last, tile});
    }
    std::ranges::stable_sort(ready_[thread], {}, &Ready::after);
  }
}

WindowsOfTiles TileLoop::plan_waves(const Tiles& tiles) {
  find_when_ready(tiles);
  WindowsOfTiles windows{std::vector<std::int32_t>(tiles.tiles().size(), -1), 0};
  const auto window_of = [&](std::size_t tile) -> std::int32_t& { return windows.of_tile[tile]; };
  // How many updates still read the window of a tile.
  std::vector<int> readers(tiles.tiles().size(), 0);
  for (const Tile& tile : tiles.tiles())
    tiles.for_each_around(tile, [&](const Tile& around) { ++readers[index_of(around, tiles)]; });
  for (std::size_t thread = 0; thread + 1 < shares_.size(); ++thread) {
    std::vector<std::int32_t> unused;
    const auto take = [&](std::size_t tile, std::size_t) {
      if (tiles.tiles()[tile].window < 0) return;
      if (unused.empty()) unused.push_back(windows.count++);
      window_of(tile) = unused.back();
      unused.pop_back();
    };
    const auto give_back = [&](std::size_t updated, std::size_t) {
      tiles.for_each_around(tiles.tiles()[updated], [&](const Tile& around) {
        const std::size_t tile = index_of(around, tiles);
        if (--readers[tile] == 0 && window_of(tile) >= 0) unused.push_back(window_of(tile));
      });
    };
    roll(thread, take, give_back);
  }
  return windows;
}

}  // namespace trajan
