#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "solver/simulation/particles.h"

namespace trajan {
namespace {

struct TileHash {
  std::size_t operator()(const TileIndex& at) const {
    std::size_t hash = 0;
    for (std::int32_t i : at) hash = hash * 0x9E3779B97F4A7C15u + static_cast<std::size_t>(i);
    return hash;
  }
};

void include(CellRange& range, const CellRange& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range.lowest[axis] = std::min(range.lowest[axis], other.lowest[axis]);
    range.highest[axis] = std::max(range.highest[axis], other.highest[axis]);
  }
}

/// Which tile every particle of a body is in, and where in the order of a tile. Takes time and memory that depend
/// on the number of particles alone, however far they are apart.
struct Places {
  struct Place {
    TileIndex tile{};
    CellRange cells;  ///< of the window, in which the tile's particles are
  };
  int bins;                         ///< of a tile
  std::vector<Place> tiles;         ///< in order
  std::vector<std::uint32_t> tile;  ///< by slot, index into tiles
  std::vector<std::uint8_t> bin;    ///< by slot

  Places(const Grid& grid, const Tiles& grid_tiles, bool staggered, const BodyParticles& body)
      : bins(1), tile(body.size()), bin(body.size()) {
    const Layout& layout = grid_tiles.layout();
    // Stencils that change in the middle of cells begin at one more node along each axis.
    const int bins_along = layout.side + staggered;
    const double shift = staggered ? 0.5 : 0;
    for (int axis = 0; axis < layout.dimensions; ++axis) bins *= bins_along;
    const double inverse_cell = 1 / grid.cell;
    const double origin[] = {grid.origin.x, grid.origin.y, grid.origin.z};
    std::unordered_map<TileIndex, std::uint32_t, TileHash> known;
    std::uint32_t index = 0;
    TileIndex last{};
    for (std::size_t slot = 0; slot < body.size(); ++slot) {
      TileIndex at{}, cell{};
      int bin_in_tile = 0;
      for (int axis = layout.dimensions - 1; axis >= 0; --axis) {
        double x = (body.component(Attribute::position_x, axis)[slot] - origin[axis]) * inverse_cell;
        if (const int period = grid_tiles.period(axis); period > 0) x -= period * std::floor(x / period);
        const auto i = static_cast<std::int32_t>(std::floor(x));
        at[axis] = i >> layout.tile_bits;
        const std::int32_t in_tile = i & (layout.side - 1);
        cell[axis] = in_tile + 1;
        bin_in_tile = bin_in_tile * bins_along + in_tile + (x - i >= 1 - shift);
      }
      at = grid_tiles.wrapped(at);
      if (slot == 0 || at != last) {
        index = known.emplace(at, static_cast<std::uint32_t>(tiles.size())).first->second;
        if (index == tiles.size()) tiles.push_back({at, {cell, cell}});
        last = at;
      }
      include(tiles[index].cells, {cell, cell});
      tile[slot] = index;
      bin[slot] = static_cast<std::uint8_t>(bin_in_tile);
    }
    order_tiles();
  }

  std::size_t bin_of(std::size_t slot) const {
    return std::size_t{tile[slot]} * static_cast<std::size_t>(bins) + bin[slot];
  }

 private:
  void order_tiles() {
    const std::vector<Place> found = tiles;
    const auto place_before = [](const Place& a, const Place& b) { return before(a.tile, b.tile); };
    std::sort(tiles.begin(), tiles.end(), place_before);
    std::vector<std::uint32_t> rank(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      rank[i] = static_cast<std::uint32_t>(std::lower_bound(tiles.begin(), tiles.end(), found[i], place_before) -
                                           tiles.begin());
    for (std::uint32_t& t : tile) t = rank[t];
  }
};

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& slot_of, std::vector<T>& spare) {
  if (values.empty()) return;
  spare.resize(values.size());
  for (std::size_t i = 0; i < slot_of.size(); ++i) spare[i] = values[slot_of[i]];
  values.swap(spare);
}

/// Particles of one body in one tile, and the cells that they are in.
struct TileRun {
  TileIndex tile{};
  std::uint32_t field = 0, body = 0, begin = 0, end = 0;
  CellRange cells;
};

/// Orders a body's particles by counting how many are in each bin. Appends its runs.
void reorder(const Grid& grid, const Tiles& tiles, bool staggered, BodyParticles& body, std::uint32_t index,
             std::vector<TileRun>& runs) {
  const Places places(grid, tiles, staggered, body);
  const auto bins = static_cast<std::size_t>(places.bins);
  std::vector<std::uint32_t> begin(places.tiles.size() * bins + 1, 0);
  for (std::size_t slot = 0; slot < body.size(); ++slot) ++begin[places.bin_of(slot) + 1];
  for (std::size_t bin = 1; bin < begin.size(); ++bin) begin[bin] += begin[bin - 1];
  for (std::size_t t = 0; t < places.tiles.size(); ++t)
    runs.push_back(
        {places.tiles[t].tile, body.field, index, begin[t * bins], begin[(t + 1) * bins], places.tiles[t].cells});

  std::vector<std::uint32_t> slot_of(body.size());
  for (std::uint32_t slot = 0; slot < body.size(); ++slot) slot_of[begin[places.bin_of(slot)]++] = slot;
  std::vector<double> spare;
  for (std::vector<double>& array : body.arrays) permute(array, slot_of, spare);
  std::vector<std::uint32_t> spare_numbers;
  permute(body.number, slot_of, spare_numbers);
}

}  // namespace

void sort_into_tiles(const Grid& grid, bool staggered, std::vector<BodyParticles>& bodies, Tiles& tiles) {
  const Layout& layout = tiles.layout();
  std::vector<TileRun> runs;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) reorder(grid, tiles, staggered, bodies[b], b, runs);
  std::sort(runs.begin(), runs.end(), [](const TileRun& a, const TileRun& b) {
    if (a.tile != b.tile) return before(a.tile, b.tile);
    return a.field != b.field ? a.field < b.field : a.body < b.body;
  });

  std::vector<OccupiedTile> occupied;
  std::vector<std::uint32_t> blocks_of;
  std::vector<BlockRange> blocks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TileRun& run = runs[i];
    if (i == 0 || runs[i - 1].tile != run.tile || runs[i - 1].field != run.field) {
      occupied.push_back({run.tile, run.field, run.cells});
      blocks_of.push_back(0);
    }
    include(occupied.back().cells, run.cells);
    for (std::uint32_t begin = run.begin; begin < run.end; begin += block_size) {
      const std::uint32_t count = std::min<std::uint32_t>(block_size, run.end - begin);
      blocks.push_back({begin, static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(run.body)});
      ++blocks_of.back();
    }
  }
  // The margin of one cell for drifting.
  for (OccupiedTile& tile : occupied)
    for (int axis = 0; axis < layout.dimensions; ++axis) {
      --tile.cells.lowest[axis];
      ++tile.cells.highest[axis];
    }
  tiles.rebuild(occupied, std::move(blocks), blocks_of);
}

}  // namespace trajan
