#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "solver/simulation/particles.h"

namespace trajan {
namespace {

/// A tile, ordered row by row.
struct TileKey {
  std::int32_t y = 0, x = 0;
  auto operator<=>(const TileKey&) const = default;
};
struct TileHash {
  std::size_t operator()(const TileKey& key) const {
    return static_cast<std::size_t>(key.y) * 0x9E3779B97F4A7C15u + static_cast<std::size_t>(key.x);
  }
};

/// Which tile and which of its cells every particle of a body is in. Takes time and memory that depend on
/// the number of particles alone, however far they are apart.
struct Places {
  std::vector<TileKey> tiles;       ///< in order
  std::vector<std::uint32_t> tile;  ///< by slot, index into tiles
  std::vector<std::uint8_t> cell;   ///< by slot, row by row within the tile

  Places(const Grid& grid, const BodyParticles& body) : tile(body.size()), cell(body.size()) {
    const double inverse_cell = 1 / grid.cell;
    std::unordered_map<TileKey, std::uint32_t, TileHash> known;
    TileKey last;
    std::uint32_t index = 0;
    for (std::size_t slot = 0; slot < body.size(); ++slot) {
      const double x = (body[Attribute::position_x][slot] - grid.origin.x) * inverse_cell;
      const double y = (body[Attribute::position_y][slot] - grid.origin.y) * inverse_cell;
      const auto i = static_cast<std::int32_t>(std::floor(x)), j = static_cast<std::int32_t>(std::floor(y));
      const TileKey key{j >> tile_bits, i >> tile_bits};
      if (slot == 0 || key != last) {
        index = known.emplace(key, static_cast<std::uint32_t>(tiles.size())).first->second;
        if (index == tiles.size()) tiles.push_back(key);
        last = key;
      }
      tile[slot] = index;
      cell[slot] = static_cast<std::uint8_t>((j & (tile_side - 1)) * tile_side + (i & (tile_side - 1)));
    }
    order_tiles();
  }

  std::size_t bin(std::size_t slot) const { return std::size_t{tile[slot]} * tile_nodes + cell[slot]; }

 private:
  static constexpr int tile_bits = 3;
  static_assert(1 << tile_bits == tile_side);

  void order_tiles() {
    const std::vector<TileKey> found = tiles;
    std::sort(tiles.begin(), tiles.end());
    std::vector<std::uint32_t> rank(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      rank[i] = static_cast<std::uint32_t>(std::lower_bound(tiles.begin(), tiles.end(), found[i]) - tiles.begin());
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
  TileKey tile;
  std::uint32_t body = 0, begin = 0, end = 0;
  CellRange cells;
};

void include(CellRange& range, const CellRange& other) {
  range = {std::min(range.lowest_x, other.lowest_x), std::max(range.highest_x, other.highest_x),
           std::min(range.lowest_y, other.lowest_y), std::max(range.highest_y, other.highest_y)};
}

/// Orders a body's particles by counting how many are in each cell. Appends its runs.
void reorder(const Grid& grid, BodyParticles& body, std::uint32_t index, std::vector<TileRun>& runs) {
  const Places places(grid, body);
  std::vector<std::uint32_t> begin(places.tiles.size() * tile_nodes + 1, 0);
  for (std::size_t slot = 0; slot < body.size(); ++slot) ++begin[places.bin(slot) + 1];
  for (std::size_t bin = 1; bin < begin.size(); ++bin) begin[bin] += begin[bin - 1];

  for (std::size_t t = 0; t < places.tiles.size(); ++t) {
    TileRun run{places.tiles[t], index, begin[t * tile_nodes], begin[(t + 1) * tile_nodes], {}};
    run.cells = {tile_side, 1, tile_side, 1};
    for (int c = 0; c < tile_nodes; ++c) {
      if (begin[t * tile_nodes + c] == begin[t * tile_nodes + c + 1]) continue;
      const int x = c % tile_side + 1, y = c / tile_side + 1;  // of the window
      include(run.cells, {x, x, y, y});
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

void sort_into_tiles(const Grid& grid, std::vector<BodyParticles>& bodies, Tiles& tiles, int sum_arrays) {
  std::vector<TileRun> runs;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) reorder(grid, bodies[b], b, runs);
  std::sort(runs.begin(), runs.end(), [](const TileRun& a, const TileRun& b) {
    return std::tie(a.tile, a.body) < std::tie(b.tile, b.body);
  });

  std::vector<OccupiedTile> occupied;
  std::vector<std::uint32_t> blocks_of;
  std::vector<BlockRange> blocks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TileRun& run = runs[i];
    if (i == 0 || runs[i - 1].tile != run.tile) {
      occupied.push_back({run.tile.x, run.tile.y, run.cells});
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
  for (OccupiedTile& tile : occupied) {
    CellRange& c = tile.cells;
    c = {c.lowest_x - 1, c.highest_x + 1, c.lowest_y - 1, c.highest_y + 1};
  }
  tiles.rebuild(occupied, std::move(blocks), blocks_of, sum_arrays);
}

}  // namespace trajan
