#pragma once

#include "solver/transfers/row_transfers.h"
#include "solver/transfers/stencil.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// No rows of cells: for `scatter_rows`.
struct CellByCell {};

/// Adds what particles give to their nodes. give(RowParticles) is a function that adds what they give to a row of
/// nodes, of (which row, weights, slopes[D], sums of the row). The sums of a run stay in registers until the nodes
/// change; then add(which, index of the row's first node, sum) is called for each. Where functions have rows of
/// cells and these have particles of equal mass, give_cells(RowScatter, index of the first node) is called
/// instead, unless it is CellByCell.
template <class Stencil, Layout L, int Sums, class Give, class Add, class GiveCells = CellByCell>
__attribute__((always_inline)) inline void scatter_rows(Block& block, Give&& give, Add&& add_sum,
                                                        GiveCells&& give_cells = {}) {
  using Row = typename Stencil::Row;
  const RealScratch& s = scratch_of(block);
  const auto scatter_run = [&](int begin, int end, std::int64_t node) __attribute__((always_inline)) {
    Row of_run[Stencil::rows][Sums] = {};
    const auto give_rows = [&](auto particles) __attribute__((always_inline)) {
      const auto give_row = give(particles);
      int row = 0;
      const auto to_row = [&](int, Row w, const Row* slopes) __attribute__((always_inline)) {
        give_row(row, w, slopes, of_run[row]);
        ++row;
      };
      Stencil(s, particles).for_each_row(particles, to_row);
    };
    constexpr int together = Stencil::together;
    int i = begin;
    for (; i + together <= end; i += together) give_rows(RowParticles<together>{i});
    if (together > 1 && i < end) give_rows(RowParticles<together, 1>{i});

    int row = 0;
    const auto add_sums = [&](int at, Row, const Row*) __attribute__((always_inline)) {
#pragma GCC unroll 7
      for (int sum = 0; sum < Sums; ++sum) add_sum(sum, node + at, of_run[row][sum]);
      ++row;
    };
    const RowParticles<together, 1> first{begin};
    Stencil(s, first).for_each_row(first, add_sums);
  };
  const auto scatter_stretch = [&](int begin, int end) __attribute__((always_inline)) {
    for_each_run(s, begin, end, scatter_run);
  };
  if constexpr (has_cell_rows<Stencil> && !std::is_same_v<std::remove_cvref_t<GiveCells>, CellByCell>)
    for_each_row_and_stretch(
        s, block[Attribute::reference_volume] ? 0 : s.cell_rows,
        [&](int first) __attribute__((always_inline)) { give_cells(RowScatter<L>(block, first), s.cell[first]); },
        scatter_stretch);
  else
    scatter_stretch(0, s.runs);
}

/// The same with one sum for each of so many quantities from `first` on.
template <class Stencil, Layout L, int Quantities, class Give, class GiveCells = CellByCell>
__attribute__((always_inline)) inline void scatter(Block& block, int first, Give&& give,
                                                   GiveCells&& give_cells = {}) {
  double* sums = block.sums + L.window_array(first);
  scatter_rows<Stencil, L, Quantities>(
      block, give,
      [=](int q, std::int64_t at, auto row)
          __attribute__((always_inline)) { Stencil::add_row(sums + L.window_array(q) + at, row); },
      give_cells);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
