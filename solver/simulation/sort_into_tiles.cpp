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

/// Which tile and which of its cells every particle of a body is in. Takes time and memory that depend on
/// the number of particles alone, however far they are apart.
struct Places {
  std::vector<TileIndex> tiles;     ///< in order
  std::vector<std::uint32_t> tile;  ///< by slot, index into tiles
  std::vector<std::uint8_t> cell;   ///< by slot, row by row within the tile

  Places(const Grid& grid, const Tiles& grid_tiles, const BodyParticles& body)
      : tile(body.size()), cell(body.size()) {
    const Layout& layout = grid_tiles.layout();
    const double inverse_cell = 1 / grid.cell;
    const double origin[] = {grid.origin.x, grid.origin.y, grid.origin.z};
    std::unordered_map<TileIndex, std::uint32_t, TileHash> known;
    TileIndex last{};
    std::uint32_t index = 0;
    for (std::size_t slot = 0; slot < body.size(); ++slot) {
      TileIndex at{};
      int cell_in_tile = 0;
      for (int axis = 0; axis < layout.dimensions; ++axis) {
        double x = (body.component(Attribute::position_x, axis)[slot] - origin[axis]) * inverse_cell;
        if (const int period = grid_tiles.period(axis); period > 0) x -= period * std::floor(x / period);
        const auto i = static_cast<std::int32_t>(std::floor(x));
        at[axis] = i >> layout.tile_bits;
        cell_in_tile += (i & (layout.side - 1)) * layout.tile_stride(axis);
      }
      at = grid_tiles.wrapped(at);
      if (slot == 0 || at != last) {
        index = known.emplace(at, static_cast<std::uint32_t>(tiles.size())).first->second;
        if (index == tiles.size()) tiles.push_back(at);
        last = at;
      }
      tile[slot] = index;
      cell[slot] = static_cast<std::uint8_t>(cell_in_tile);
    }
    order_tiles();
  }

  std::size_t bin(std::size_t slot) const { return std::size_t{tile[slot]} * tile_nodes + cell[slot]; }

 private:
  void order_tiles() {
    const std::vector<TileIndex> found = tiles;
    std::sort(tiles.begin(), tiles.end(), before);
    std::vector<std::uint32_t> rank(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      rank[i] = static_cast<std::uint32_t>(std::lower_bound(tiles.begin(), tiles.end(), found[i], before) -
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

void include(CellRange& range, const CellRange& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range.lowest[axis] = std::min(range.lowest[axis], other.lowest[axis]);
    range.highest[axis] = std::max(range.highest[axis], other.highest[axis]);
  }
}

/// The cell of the window that a cell of the tile is.
CellRange window_cell(const Layout& layout, int cell) {
  TileIndex at{};
  for (int axis = 0; axis < layout.dimensions; ++axis)
    at[axis] = cell / layout.tile_stride(axis) % layout.side + 1;
  return {at, at};
}

/// Orders a body's particles by counting how many are in each cell. Appends its runs.
void reorder(const Grid& grid, const Tiles& tiles, BodyParticles& body, std::uint32_t index,
             std::vector<TileRun>& runs) {
  const Layout& layout = tiles.layout();
  const Places places(grid, tiles, body);
  std::vector<std::uint32_t> begin(places.tiles.size() * tile_nodes + 1, 0);
  for (std::size_t slot = 0; slot < body.size(); ++slot) ++begin[places.bin(slot) + 1];
  for (std::size_t bin = 1; bin < begin.size(); ++bin) begin[bin] += begin[bin - 1];

  for (std::size_t t = 0; t < places.tiles.size(); ++t) {
    TileRun run{places.tiles[t], body.field, index, begin[t * tile_nodes], begin[(t + 1) * tile_nodes], {}};
    bool first = true;
    for (int c = 0; c < tile_nodes; ++c) {
      if (begin[t * tile_nodes + c] == begin[t * tile_nodes + c + 1]) continue;
      const CellRange cell = window_cell(layout, c);
      if (first) run.cells = cell;
      first = false;
      include(run.cells, cell);
    }
    runs.push_back(run);
  }

  std::vector<std::uint32_t> slot_of(body.size());
  for (std::uint32_t slot = 0; slot < body.size(); ++slot) slot_of[begin[places.bin(slot)]++] = slot;
  std::vector<double> spare;
  for (std::vector<double>& array : body.arrays) permute(array, slot_of, spare);
  std::vector<std::uint32_t> spare_numbers;
  permute(body.number, slot_of, spare_numbers);
}

}  // namespace

void sort_into_tiles(const Grid& grid, std::vector<BodyParticles>& bodies, Tiles& tiles) {
  const Layout& layout = tiles.layout();
  std::vector<TileRun> runs;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) reorder(grid, tiles, bodies[b], b, runs);
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
