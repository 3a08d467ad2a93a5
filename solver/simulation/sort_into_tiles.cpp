#include <algorithm>
#include <cmath>
#include <tuple>

#include "solver/simulation/particles.h"

namespace trajan {
namespace {

struct Place {
  std::int32_t tile_x, tile_y;
  std::int32_t cell_x, cell_y;  ///< of the window, 1 .. 8
};

class Places {
 public:
  Places(const Grid& grid, const BodyParticles& body)
      : grid_(grid),
        inverse_cell_(1 / grid.cell),
        x_(body[Attribute::position_x]),
        y_(body[Attribute::position_y]) {}

  Place operator()(std::uint32_t slot) const {
    const auto cell_x = static_cast<std::int32_t>(std::floor((x_[slot] - grid_.origin.x) * inverse_cell_));
    const auto cell_y = static_cast<std::int32_t>(std::floor((y_[slot] - grid_.origin.y) * inverse_cell_));
    const std::int32_t tile_x = cell_x >> 3, tile_y = cell_y >> 3;
    static_assert(tile_side == 8);
    return {tile_x, tile_y, cell_x - 8 * tile_x + 1, cell_y - 8 * tile_y + 1};
  }

  /// Orders by tile, then by cell, both row by row.
  std::pair<std::uint64_t, std::uint32_t> key(std::uint32_t slot) const {
    const Place p = (*this)(slot);
    constexpr std::uint32_t bias = 1u << 31;
    const std::uint64_t tile = static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.tile_y) + bias) << 32 |
                               (static_cast<std::uint32_t>(p.tile_x) + bias);
    return {tile, static_cast<std::uint32_t>(p.cell_y * 16 + p.cell_x)};
  }

 private:
  const Grid& grid_;
  double inverse_cell_;
  const std::vector<double>& x_;
  const std::vector<double>& y_;
};

void reorder(const Grid& grid, BodyParticles& body) {
  const Places places(grid, body);
  struct Entry {
    std::uint64_t tile;
    std::uint32_t cell, slot;
    bool operator<(const Entry& other) const {
      return std::tie(tile, cell, slot) < std::tie(other.tile, other.cell, other.slot);
    }
  };
  std::vector<Entry> entries(body.size());
  for (std::uint32_t slot = 0; slot < entries.size(); ++slot) {
    const auto [tile, cell] = places.key(slot);
    entries[slot] = {tile, cell, slot};
  }
  std::sort(entries.begin(), entries.end());
  std::vector<double> sorted(body.size());
  for (std::vector<double>& array : body.arrays) {
    if (array.empty()) continue;
    for (std::size_t i = 0; i < entries.size(); ++i) sorted[i] = array[entries[i].slot];
    array.swap(sorted);
  }
  std::vector<std::uint32_t> numbers(body.size());
  for (std::size_t i = 0; i < entries.size(); ++i) numbers[i] = body.number[entries[i].slot];
  body.number.swap(numbers);
}

/// Particles of one body in one tile, and the cells they are in.
struct TileRun {
  std::uint64_t tile;
  std::uint32_t body, begin, end;
  OccupiedTile where;
};

void find_runs(const Grid& grid, const BodyParticles& body, std::uint32_t index, std::vector<TileRun>& runs) {
  const Places places(grid, body);
  for (std::uint32_t slot = 0; slot < body.size(); ++slot) {
    const Place p = places(slot);
    const std::uint64_t tile = places.key(slot).first;
    if (slot == 0 || runs.back().tile != tile)
      runs.push_back({tile, index, slot, slot, {p.tile_x, p.tile_y, {p.cell_x, p.cell_x, p.cell_y, p.cell_y}}});
    TileRun& run = runs.back();
    CellRange& cells = run.where.cells;
    run.end = slot + 1;
    cells.lowest_x = std::min(cells.lowest_x, p.cell_x);
    cells.highest_x = std::max(cells.highest_x, p.cell_x);
    cells.lowest_y = std::min(cells.lowest_y, p.cell_y);
    cells.highest_y = std::max(cells.highest_y, p.cell_y);
  }
}

CellRange united(const CellRange& a, const CellRange& b) {
  return {std::min(a.lowest_x, b.lowest_x), std::max(a.highest_x, b.highest_x), std::min(a.lowest_y, b.lowest_y),
          std::max(a.highest_y, b.highest_y)};
}

}  // namespace

void sort_into_tiles(const Grid& grid, std::vector<BodyParticles>& bodies, Tiles& tiles, int sum_arrays) {
  std::vector<TileRun> runs;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    reorder(grid, bodies[b]);
    find_runs(grid, bodies[b], b, runs);
  }
  std::sort(runs.begin(), runs.end(), [](const TileRun& a, const TileRun& b) {
    return std::tie(a.tile, a.body) < std::tie(b.tile, b.body);
  });

  std::vector<OccupiedTile> occupied;
  std::vector<std::uint32_t> blocks_of;
  std::vector<BlockRange> blocks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TileRun& run = runs[i];
    if (i == 0 || runs[i - 1].tile != run.tile) {
      occupied.push_back(run.where);
      blocks_of.push_back(0);
    }
    occupied.back().cells = united(occupied.back().cells, run.where.cells);
    for (std::uint32_t begin = run.begin; begin < run.end; begin += block_size) {
      const std::uint32_t count = std::min<std::uint32_t>(block_size, run.end - begin);
      blocks.push_back({begin, static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(run.body)});
      ++blocks_of.back();
    }
  }
  // The margin of one cell for drifting.
  for (OccupiedTile& tile : occupied)
    tile.cells = {tile.cells.lowest_x - 1, tile.cells.highest_x + 1, tile.cells.lowest_y - 1,
                  tile.cells.highest_y + 1};
  tiles.rebuild(occupied, std::move(blocks), blocks_of, sum_arrays);
}

}  // namespace trajan
