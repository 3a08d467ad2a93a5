#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <unordered_map>
#include <utility>

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

/// Where a position is among the tiles.
class PlaceFinder {
 public:
  struct Found {
    TileIndex tile{};
    TileIndex cell{};  ///< of the window
    int bin = 0;       ///< in the order of a tile
  };

  PlaceFinder(const Grid& grid, const Tiles& tiles, bool staggered)
      : tiles_(tiles),
        // Stencils that change in the middle of cells begin at one more node along each axis.
        bins_along_(tiles.layout().side + staggered),
        shift_(staggered ? 0.5 : 0),
        inverse_cell_(1 / grid.cell),
        origin_{grid.origin.x, grid.origin.y, grid.origin.z} {}

  int bins() const {
    int bins = 1;
    for (int axis = 0; axis < tiles_.layout().dimensions; ++axis) bins *= bins_along_;
    return bins;
  }

  Found operator()(const std::array<double, 3>& position) const {
    const Layout& layout = tiles_.layout();
    Found found;
    for (int axis = layout.dimensions - 1; axis >= 0; --axis) {
      double x = (position[axis] - origin_[axis]) * inverse_cell_;
      if (const int period = tiles_.period(axis); period > 0) {
        x -= period * std::floor(x / period);
        // Rounding.
        if (x >= period) x = 0;
      }
      const auto i = static_cast<std::int32_t>(std::floor(x));
      found.tile[axis] = i >> layout.tile_bits;
      const std::int32_t in_tile = i & (layout.side - 1);
      found.cell[axis] = in_tile + 1;
      found.bin = found.bin * bins_along_ + in_tile + (x - i >= 1 - shift_);
    }
    return found;
  }

 private:
  const Tiles& tiles_;
  int bins_along_;
  double shift_, inverse_cell_;
  std::array<double, 3> origin_;
};

/// The tiles that positions are in, and in each the cells of the window that they are in. Takes time and memory
/// that depend on the number of positions alone, however far they are apart.
class FoundTiles {
 public:
  struct Place {
    TileIndex tile{};
    CellRange cells;
  };

  /// Index of the tile, into places().
  std::uint32_t add(const PlaceFinder::Found& found) {
    if (places_.empty() || found.tile != places_[last_].tile) {
      last_ = known_.emplace(found.tile, static_cast<std::uint32_t>(places_.size())).first->second;
      if (last_ == places_.size()) places_.push_back({found.tile, {found.cell, found.cell}});
    }
    include(places_[last_].cells, {found.cell, found.cell});
    return last_;
  }
  void add(const FoundTiles& other) {
    for (const Place& place : other.places_) {
      add({place.tile, place.cells.lowest, 0});
      include(places_[last_].cells, place.cells);
    }
  }
  void put_in_order() { std::sort(places_.begin(), places_.end(), is_before); }
  /// Where each tile is among those of another that has them all and is in order.
  std::vector<std::uint32_t> ranks(const FoundTiles& all) const {
    std::vector<std::uint32_t> rank(places_.size());
    for (std::size_t i = 0; i < rank.size(); ++i)
      rank[i] = static_cast<std::uint32_t>(
          std::lower_bound(all.places_.begin(), all.places_.end(), places_[i], is_before) - all.places_.begin());
    return rank;
  }
  const std::vector<Place>& places() const { return places_; }

 private:
  static bool is_before(const Place& a, const Place& b) { return before(a.tile, b.tile); }

  std::unordered_map<TileIndex, std::uint32_t, TileHash> known_;
  std::vector<Place> places_;
  std::uint32_t last_ = 0;
};

/// Calls of(thread, begin, end) on every thread, with its share of so many items.
template <class Function>
void for_each_share(ThreadPool& pool, std::size_t size, Function&& of) {
  const auto threads = static_cast<std::size_t>(pool.size());
  pool.run([&](int thread) {
    const auto share = static_cast<std::size_t>(thread);
    of(share, size * share / threads, size * (share + 1) / threads);
  });
}

/// The bin of every particle of a body: the bins of a tile are one after the other, and so are the tiles.
struct Places {
  std::size_t bins_of_tile;
  std::vector<FoundTiles::Place> tiles;  ///< in order
  std::vector<std::uint32_t> bin;        ///< by slot

  Places(const Grid& grid, const Tiles& grid_tiles, bool staggered, const BodyParticles& body, ThreadPool& pool)
      : bin(body.size()) {
    const PlaceFinder find(grid, grid_tiles, staggered);
    const auto bins = static_cast<std::uint32_t>(find.bins());
    const int axes = grid_tiles.layout().dimensions;
    std::vector<FoundTiles> found(static_cast<std::size_t>(pool.size()));
    for_each_share(pool, bin.size(), [&](std::size_t thread, std::size_t begin, std::size_t end) {
      FoundTiles mine;
      std::array<double, 3> position{};
      for (std::size_t slot = begin; slot < end; ++slot) {
        for (int axis = 0; axis < axes; ++axis) position[axis] = body.component(Attribute::position_x, axis)[slot];
        const PlaceFinder::Found place = find(position);
        bin[slot] = mine.add(place) * bins + static_cast<std::uint32_t>(place.bin);
      }
      found[thread] = std::move(mine);
    });
    FoundTiles all;
    for (const FoundTiles& of_thread : found) all.add(of_thread);
    all.put_in_order();
    for_each_share(pool, bin.size(), [&](std::size_t thread, std::size_t begin, std::size_t end) {
      const std::vector<std::uint32_t> rank = found[thread].ranks(all);
      for (std::size_t slot = begin; slot < end; ++slot)
        bin[slot] = rank[bin[slot] / bins] * bins + bin[slot] % bins;
    });
    bins_of_tile = bins;
    tiles = all.places();
  }
};

/// The slots in the order of their bins, those of a bin in the order they have. By slot, `bin` says which;
/// begin[bin] is where a bin begins.
std::vector<std::uint32_t> order_of(const std::vector<std::uint32_t>& bin, std::vector<std::uint32_t>& begin,
                                    ThreadPool& pool) {
  // A thread's share of a bin comes after those of the threads before it, so that the order is that of one thread.
  std::vector<std::vector<std::uint32_t>> next(static_cast<std::size_t>(pool.size()));
  for_each_share(pool, bin.size(), [&](std::size_t thread, std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> count(begin.size(), 0);
    for (std::size_t slot = first; slot < last; ++slot) ++count[bin[slot]];
    next[thread] = std::move(count);
  });
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < begin.size(); ++b) {
    begin[b] = sum;
    for (std::vector<std::uint32_t>& of_thread : next) sum += std::exchange(of_thread[b], sum);
  }
  std::vector<std::uint32_t> slot_of(bin.size());
  for_each_share(pool, bin.size(), [&](std::size_t thread, std::size_t first, std::size_t last) {
    std::vector<std::uint32_t>& place = next[thread];
    for (std::size_t slot = first; slot < last; ++slot)
      slot_of[place[bin[slot]]++] = static_cast<std::uint32_t>(slot);
  });
  return slot_of;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::uint32_t>& slot_of, std::vector<T>& spare,
             ThreadPool& pool) {
  // What is the same everywhere, as stresses are at first, is in any order already.
  if (values.size() < 2 || std::memcmp(&values[0], &values[1], (values.size() - 1) * sizeof(T)) == 0) return;
  spare.resize(values.size());
  for_each_share(pool, slot_of.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) spare[i] = values[slot_of[i]];
  });
  values.swap(spare);
}

/// Particles of one body in one tile, and the cells that they are in.
struct TileRun {
  TileIndex tile{};
  std::uint32_t field = 0, body = 0, begin = 0, end = 0;
  CellRange cells;
};

/// The order of a body's particles by tiles and bins; appends its runs.
std::vector<std::uint32_t> find_order(const Grid& grid, const Tiles& tiles, bool staggered,
                                      const BodyParticles& body, std::uint32_t index, std::vector<TileRun>& runs,
                                      ThreadPool& pool) {
  const Places places(grid, tiles, staggered, body, pool);
  std::vector<std::uint32_t> begin(places.tiles.size() * places.bins_of_tile + 1);
  std::vector<std::uint32_t> slot_of = order_of(places.bin, begin, pool);
  for (std::size_t t = 0; t < places.tiles.size(); ++t)
    runs.push_back({places.tiles[t].tile, body.field, index, begin[t * places.bins_of_tile],
                    begin[(t + 1) * places.bins_of_tile], places.tiles[t].cells});
  return slot_of;
}

void reorder(BodyParticles& body, const std::vector<std::uint32_t>& slot_of, ThreadPool& pool) {
  std::vector<double> spare;
  for (std::vector<double>& array : body.arrays) permute(array, slot_of, spare, pool);
  std::vector<double>().swap(spare);
  std::vector<float> spare_floats;
  for (std::vector<float>& array : body.floats) permute(array, slot_of, spare_floats, pool);
  std::vector<std::uint32_t> spare_numbers;
  permute(body.number, slot_of, spare_numbers, pool);
}

/// Of one cell, for drifting.
void add_margins(std::vector<OccupiedTile>& occupied, const Layout& layout) {
  for (OccupiedTile& tile : occupied)
    for (int axis = 0; axis < layout.dimensions; ++axis) {
      --tile.cells.lowest[axis];
      ++tile.cells.highest[axis];
    }
}

}  // namespace

std::vector<OccupiedTile> occupied_tiles(const Model& model, const Tiles& tiles) {
  const PlaceFinder find(model.grid, tiles, false);
  std::map<std::uint32_t, FoundTiles> by_field;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    FoundTiles& found = by_field[model.contacts.field_of.empty() ? 0 : model.contacts.field_of[b]];
    model.bodies[b].lattice.for_each_point([&](std::int64_t, Vector at) { found.add(find({at.x, at.y, at.z})); });
  }
  std::vector<OccupiedTile> occupied;
  for (const auto& [field, found] : by_field)
    for (const FoundTiles::Place& place : found.places()) occupied.push_back({place.tile, field, place.cells});
  add_margins(occupied, tiles.layout());
  return occupied;
}

void sort_into_tiles(const Grid& grid, bool staggered, std::vector<BodyParticles>& bodies, Tiles& tiles,
                     ThreadPool& pool) {
  std::vector<TileRun> runs;
  for (std::uint32_t b = 0; b < bodies.size(); ++b)
    reorder(bodies[b], find_order(grid, tiles, staggered, bodies[b], b, runs, pool), pool);
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
  add_margins(occupied, tiles.layout());
  tiles.rebuild(occupied, std::move(blocks), blocks_of);
}

}  // namespace trajan
