#pragma once

#include "solver/transfers/runs.h"
#include "solver/transfers/strip_scatter.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// No strips: for `scatter_rows`.
struct RunByRun {};

/// Adds what particles give to their nodes. give(RowParticles) is a function that adds what they give to a row of
/// nodes, of (which row, weights, slopes[D], sums of the row). The sums of a run stay in registers until the nodes
/// change; then add(which, index of the row's first node, sum) is called for each. Where particles lie in strips
/// give_strips(StripScatter) is called instead, unless it is RunByRun.
template <class Stencil, Layout L, int Sums, class Give, class Add, class GiveStrips = RunByRun>
__attribute__((always_inline)) inline void scatter_rows(Block& block, Give&& give, Add&& add_sum,
                                                        GiveStrips&& give_strips = {}) {
  using Row = typename Stencil::Row;
  RealScratch& s = scratch_of(block);
  if constexpr (has_strips<Stencil> && !std::is_same_v<std::remove_cvref_t<GiveStrips>, RunByRun>)
    if (s.by_strips) return give_strips(StripScatter<Stencil::nodes, L>(block));
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
  know_runs(block);
  for_each_run(s, scatter_run);
}

/// The same with one sum for each of so many quantities from `first` on.
template <class Stencil, Layout L, int Quantities, class Give, class GiveStrips = RunByRun>
__attribute__((always_inline)) inline void scatter(Block& block, int first, Give&& give,
                                                   GiveStrips&& give_strips = {}) {
  double* sums = block.sums + L.window_array(first);
  scatter_rows<Stencil, L, Quantities>(
      block, give,
      [=](int q, std::int64_t at, auto row)
          __attribute__((always_inline)) { Stencil::add_row(sums + L.window_array(q) + at, row); },
      give_strips);
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
