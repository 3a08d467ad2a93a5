#pragma once

#include <cstdint>
#include <type_traits>

#include "solver/transfers/eight_lanes.h"
#include "solver/transfers/stencil.h"

/// Strips: up to eight particles, one after the other, that are in ever higher ones of eight neighbouring cells of
/// a row. Each cell is a lane, so that particles that share nodes never meet before their sums do. In a plane and
/// in floats particles are put in such an order (`sort_into_tiles`): first ones of all cells of a row, then the
/// second ones, and so on. They may drift: a strip ends where its cells no longer grow.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Whether particles are worked on so.
template <class Stencil>
inline constexpr bool has_strips = false;
#ifdef __AVX2__
template <int Nodes, Layout L, class Slopes>
inline constexpr bool has_strips<ProductStencil<Nodes, L, Slopes>> =
    L.dimensions == 2 && std::is_same_v<Real, float> && !std::is_same_v<Slopes, LeverSlopes>;
#endif

/// A number of each cell of a strip.
using Cells = VectorOf<float, 8>::Type;
inline constexpr int cells_of_strip = 8;

/// A strip that has a particle in every cell.
class FullStrip {
 public:
  FullStrip(const RealScratch& s, int strip)
      : first_(s.full_strips.begin[strip]), cell_(s.full_strips.cell[strip]) {}
  static const auto& list(const RealScratch& s) { return s.full_strips; }
  int first() const { return first_; }
  int cell() const { return cell_; }  ///< the first one that has a lane
  /// Of its particles, by cell.
  __attribute__((always_inline)) Cells load(const float* values) const {
    return trajan::load<Cells>(values + first_);
  }
  /// Without those of cells that have none.
  __attribute__((always_inline)) Cells only_there(Cells cells) const { return cells; }
  /// What cells have, by particle.
  __attribute__((always_inline)) Cells in_order(Cells cells) const { return cells; }

 private:
  int first_, cell_;
};

/// Any other one: the particles' lanes are found by permutations.
class SparseStrip {
 public:
  SparseStrip(const RealScratch& s, int strip)
      : first_(s.sparse_strips.begin[strip]),
        cell_(s.sparse_strips.cell[strip]),
        particle_(count_lanes_before(s.sparse_strips.lanes[strip])),
        particles_(lanes_of((1 << s.sparse_strips.count[strip]) - 1)),
        lane_(trajan::load<EightLanes>(s.cell + first_) - cell_),
        there_(lanes_of(s.sparse_strips.lanes[strip])) {}
  static const auto& list(const RealScratch& s) { return s.sparse_strips; }
  int first() const { return first_; }
  int cell() const { return cell_; }
  __attribute__((always_inline)) Cells load(const float* values) const {
    return only_there(permuted(load_only(values + first_, particles_), particle_));
  }
  __attribute__((always_inline)) Cells only_there(Cells cells) const { return there_ ? cells : Cells{}; }
  __attribute__((always_inline)) Cells in_order(Cells cells) const { return permuted(cells, lane_); }

 private:
  int first_, cell_;
  EightLanes particle_, particles_, lane_, there_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
