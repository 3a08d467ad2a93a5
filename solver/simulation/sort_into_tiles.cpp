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

/// Where positions are along one axis.
struct AxisFinder {
  struct Found {
    std::int32_t tile, cell;  ///< the cell is one of the tile's
  };
  double origin, inverse_cell, begin, period;
  std::int32_t tile_bits;

  Found operator()(double position) const {
    double x = (position - origin) * inverse_cell - begin;
    if (period > 0) {
      x -= period * std::floor(x / period);
      x = x >= period ? 0 : x;  // rounding
    }
    const auto cell = static_cast<std::int32_t>(std::floor(x));
    return {cell >> tile_bits, cell & ((1 << tile_bits) - 1)};
  }
};

/// Where positions are among the tiles.
class PlaceFinder {
 public:
  PlaceFinder(const Grid& grid, const Tiles& tiles) : axes_(static_cast<std::size_t>(tiles.layout().dimensions)) {
    const double origin[] = {grid.origin.x, grid.origin.y, grid.origin.z};
    for (std::size_t axis = 0; axis < axes_; ++axis)
      along_[axis] = {.origin = origin[axis],
                      .inverse_cell = 1 / grid.cell,
                      .begin = begin_of_cells(tiles.layout().reach),
                      .period = static_cast<double>(tiles.period(static_cast<int>(axis))),
                      .tile_bits = tiles.layout().tile_bits};
  }

  std::size_t axes() const { return axes_; }
  const AxisFinder& along(std::size_t axis) const { return along_[axis]; }

 private:
  std::size_t axes_;
  std::array<AxisFinder, 3> along_{};
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
  std::uint32_t add(const Place& place) {
    if (places_.empty() || place.tile != places_[last_].tile) {
      last_ = known_.emplace(place.tile, static_cast<std::uint32_t>(places_.size())).first->second;
      if (last_ == places_.size()) places_.push_back(place);
    }
    include(places_[last_].cells, place.cells);
    return last_;
  }
  void add(const FoundTiles& other) {
    for (const Place& place : other.places_) add(place);
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

/// Some particles, along each axis by itself: a compiler can do that for several at once.
class FoundParticles {
 public:
  static constexpr std::size_t most = 256;

  FoundParticles(const PlaceFinder& find, const BodyParticles& body, std::size_t begin, std::size_t count)
      : axes_(find.axes()) {
    std::fill_n(bin, count, 0);
    for (std::size_t axis = axes_; axis-- > 0;) {
      const AxisFinder along = find.along(axis);
      const double* x = body.component(Attribute::position_x, static_cast<int>(axis)).data() + begin;
      std::int32_t *tile = tile_[axis], *cell = cell_[axis];
#pragma GCC ivdep
      for (std::size_t i = 0; i < count; ++i) {
        const AxisFinder::Found found = along(x[i]);
        tile[i] = found.tile;
        cell[i] = found.cell;
        bin[i] = (bin[i] << along.tile_bits) + found.cell;
      }
    }
  }

  /// Where those end that are in the same tile as one of them, and the cells that they are in.
  std::size_t end_of_tile(std::size_t begin, std::size_t count, FoundTiles::Place& place) const {
    std::size_t end = begin + 1;
    const auto same = [&](std::size_t axis) { return tile_[axis][end] == tile_[axis][begin]; };
    while (end < count && same(0) && (axes_ < 2 || same(1)) && (axes_ < 3 || same(2))) ++end;
    place = {};
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      const auto [lowest, highest] = std::minmax_element(cell_[axis] + begin, cell_[axis] + end);
      place.tile[axis] = tile_[axis][begin];
      place.cells.lowest[axis] = 1 + *lowest;
      place.cells.highest[axis] = 1 + *highest;
    }
    return end;
  }

  std::int32_t bin[most];  ///< which of its tile's cells, x fastest

 private:
  std::size_t axes_;
  std::int32_t tile_[3][most], cell_[3][most];
};

/// The bin of every particle of a body: a tile has as many as cells, one after the other, and so are the tiles.
struct Places {
  static constexpr std::uint32_t bins_of_tile = tile_nodes;
  std::vector<FoundTiles::Place> tiles;  ///< in order
  std::vector<std::uint32_t> bin;        ///< by slot

  Places(const Grid& grid, const Tiles& grid_tiles, const BodyParticles& body, ThreadPool& pool)
      : bin(body.size()) {
    const PlaceFinder find(grid, grid_tiles);
    std::vector<FoundTiles> found(static_cast<std::size_t>(pool.size()));
    for_each_share(pool, bin.size(), [&](std::size_t thread, std::size_t begin, std::size_t end) {
      FoundTiles mine;
      for (; begin < end; begin += FoundParticles::most) {
        const std::size_t count = std::min(FoundParticles::most, end - begin);
        const FoundParticles particles(find, body, begin, count);
        FoundTiles::Place place;
        for (std::size_t i = 0; i < count;) {
          const std::size_t end_of_tile = particles.end_of_tile(i, count, place);
          const std::uint32_t tile = mine.add(place);
          for (; i < end_of_tile; ++i)
            bin[begin + i] = tile * bins_of_tile + static_cast<std::uint32_t>(particles.bin[i]);
        }
      }
      found[thread] = std::move(mine);
    });
    FoundTiles all;
    for (const FoundTiles& of_thread : found) all.add(of_thread);
    all.put_in_order();
    for_each_share(pool, bin.size(), [&](std::size_t thread, std::size_t begin, std::size_t end) {
      const std::vector<std::uint32_t> rank = found[thread].ranks(all);
      for (std::size_t slot = begin; slot < end; ++slot)
        bin[slot] = rank[bin[slot] / bins_of_tile] * bins_of_tile + bin[slot] % bins_of_tile;
    });
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

/// Of each row of bins the first ones of all bins, then the second ones, and so on. `begin`: where bins begin.
void order_by_strips(std::vector<std::uint32_t>& slot_of, const std::vector<std::uint32_t>& begin,
                     std::size_t bins_of_row, ThreadPool& pool) {
  for_each_share(pool, begin.size() / bins_of_row, [&](std::size_t, std::size_t row, std::size_t end_row) {
    std::vector<std::uint32_t> by_bin;
    for (; row < end_row; ++row) {
      const std::uint32_t *first = &begin[row * bins_of_row], *last = first + bins_of_row;
      by_bin.assign(slot_of.begin() + *first, slot_of.begin() + *last);
      std::uint32_t next = *first;
      for (std::uint32_t place = 0; next < *last; ++place)
        for (const std::uint32_t* bin = first; bin < last; ++bin)
          if (bin[0] + place < bin[1]) slot_of[next++] = by_bin[bin[0] + place - *first];
    }
  });
}

/// The order of a body's particles by tiles and bins; appends its runs.
std::vector<std::uint32_t> find_order(const Grid& grid, const Tiles& tiles, CellOrder order,
                                      const BodyParticles& body, std::uint32_t index, std::vector<TileRun>& runs,
                                      ThreadPool& pool) {
  const Places places(grid, tiles, body, pool);
  std::vector<std::uint32_t> begin(places.tiles.size() * places.bins_of_tile + 1);
  std::vector<std::uint32_t> slot_of = order_of(places.bin, begin, pool);
  if (order == CellOrder::strips)
    order_by_strips(slot_of, begin, static_cast<std::size_t>(tiles.layout().side), pool);
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

/// Particles of a tile are cut into as few blocks as there must be, of about equal size and so that rows of cells
/// with four particles each stay whole.
std::uint32_t block_share(std::uint32_t particles) {
  constexpr std::uint32_t row = 32, most = block_size;
  const std::uint32_t blocks = (particles + most - 1) / most, share = (particles + blocks - 1) / blocks;
  return std::min(most, (share + row - 1) / row * row);
}

void add_margins(std::vector<OccupiedTile>& occupied, const Layout& layout) {
  if (layout.margin == Margin::none) return;
  for (OccupiedTile& tile : occupied)
    for (int axis = 0; axis < layout.dimensions; ++axis) {
      --tile.cells.lowest[axis];
      ++tile.cells.highest[axis];
    }
}

}  // namespace

std::vector<OccupiedTile> occupied_tiles(const Model& model, const Tiles& tiles) {
  const PlaceFinder find(model.grid, tiles);
  std::map<std::uint32_t, FoundTiles> by_field;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    FoundTiles& found = by_field[model.contacts.field_of.empty() ? 0 : model.contacts.field_of[b]];
    model.bodies[b].lattice.for_each_point([&](std::int64_t, Vector at) {
      const double position[] = {at.x, at.y, at.z};
      FoundTiles::Place place;
      for (std::size_t axis = 0; axis < find.axes(); ++axis) {
        const AxisFinder::Found along = find.along(axis)(position[axis]);
        place.tile[axis] = along.tile;
        place.cells.lowest[axis] = place.cells.highest[axis] = 1 + along.cell;
      }
      found.add(place);
    });
  }
  std::vector<OccupiedTile> occupied;
  for (const auto& [field, found] : by_field)
    for (const FoundTiles::Place& place : found.places()) occupied.push_back({place.tile, field, place.cells});
  add_margins(occupied, tiles.layout());
  return occupied;
}

void sort_into_tiles(const Grid& grid, CellOrder order, std::vector<BodyParticles>& bodies, Tiles& tiles,
                     ThreadPool& pool) {
  std::vector<TileRun> runs;
  for (std::uint32_t b = 0; b < bodies.size(); ++b)
    reorder(bodies[b], find_order(grid, tiles, order, bodies[b], b, runs, pool), pool);
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
    const std::uint32_t share = block_share(run.end - run.begin);
    for (std::uint32_t begin = run.begin; begin < run.end; begin += share) {
      const std::uint32_t count = std::min(share, run.end - begin);
      blocks.push_back({begin, static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(run.body)});
      ++blocks_of.back();
    }
  }
  add_margins(occupied, tiles.layout());
  tiles.rebuild(occupied, std::move(blocks), blocks_of);
}

}  // namespace trajan
