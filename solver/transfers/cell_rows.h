#pragma once

#include <array>
#include <cstddef>

#include "solver/transfers/runs.h"
#include "solver/transfers/stencil.h"

/// Rows of eight cells with four particles each, as bodies have them in a plane that have not been deformed much,
/// by linear functions and in floats: what the first particles of all cells do is one register, then what the
/// second ones do, and sums of particles and cells meet before nodes are read. Where particles lie otherwise they
/// are worked on cell by cell. By TLMPM 14.1 -> 11.0 ns per particle and step. Doubles would need registers of
/// AVX-512 (15.3 -> 14.0), with those of AVX2 they gain nothing, and bits would differ.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Whether they are worked on so.
template <class Stencil>
inline constexpr bool has_cell_rows = false;
#ifdef __AVX2__
template <Layout L>
inline constexpr bool has_cell_rows<ProductStencil<2, L, ShapeSlopes>> =
    L.dimensions == 2 && std::is_same_v<Real, float>;
#endif

inline constexpr int particles_of_cell = 4, cells_of_row = 8, particles_of_row = cells_of_row * particles_of_cell;

/// One number of each cell.
using Cells = Eight;

/// Numbers of a row's particles, by which of their cell's they are.
using ByRank = std::array<Cells, particles_of_cell>;

/// \name Of particles as they follow each other, and back
/// @{
__attribute__((always_inline)) inline ByRank by_rank(const ByRank& in_order) {
  const auto& [a, b, c, d] = in_order;
  const Cells first_ab = __builtin_shufflevector(a, b, 0, 4, 8, 12, 1, 5, 9, 13);
  const Cells last_ab = __builtin_shufflevector(a, b, 2, 6, 10, 14, 3, 7, 11, 15);
  const Cells first_cd = __builtin_shufflevector(c, d, 0, 4, 8, 12, 1, 5, 9, 13);
  const Cells last_cd = __builtin_shufflevector(c, d, 2, 6, 10, 14, 3, 7, 11, 15);
  return {__builtin_shufflevector(first_ab, first_cd, 0, 1, 2, 3, 8, 9, 10, 11),
          __builtin_shufflevector(first_ab, first_cd, 4, 5, 6, 7, 12, 13, 14, 15),
          __builtin_shufflevector(last_ab, last_cd, 0, 1, 2, 3, 8, 9, 10, 11),
          __builtin_shufflevector(last_ab, last_cd, 4, 5, 6, 7, 12, 13, 14, 15)};
}
__attribute__((always_inline)) inline ByRank in_order(const ByRank& by_rank) {
  const auto& [a, b, c, d] = by_rank;
  const Cells left_ab = __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
  const Cells left_cd = __builtin_shufflevector(c, d, 0, 8, 1, 9, 2, 10, 3, 11);
  const Cells right_ab = __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
  const Cells right_cd = __builtin_shufflevector(c, d, 4, 12, 5, 13, 6, 14, 7, 15);
  return {__builtin_shufflevector(left_ab, left_cd, 0, 1, 8, 9, 2, 3, 10, 11),
          __builtin_shufflevector(left_ab, left_cd, 4, 5, 12, 13, 6, 7, 14, 15),
          __builtin_shufflevector(right_ab, right_cd, 0, 1, 8, 9, 2, 3, 10, 11),
          __builtin_shufflevector(right_ab, right_cd, 4, 5, 12, 13, 6, 7, 14, 15)};
}
__attribute__((always_inline)) inline ByRank load_by_rank(const Real* values) {
  const auto at = [values](int k) __attribute__((always_inline)) {
    return load<Cells>(values + k * cells_of_row);
  };
  return by_rank({at(0), at(1), at(2), at(3)});
}
/// @}

/// To be called once runs are known.
inline void find_cell_rows(RealScratch& s) {
  s.cell_rows = 0;
  for (int run = 0; run + cells_of_row <= s.runs;) {
    const std::int32_t* cell = s.cell + s.run_begin[run];
    int others = s.run_begin[run + cells_of_row] - s.run_begin[run] - particles_of_row;
    others |= cell[particles_of_row - 1] - cell[0] - (cells_of_row - 1);
    if (others == 0)
      for (int i = 0; i < particles_of_row; ++i) others |= cell[i] - cell[0] - i / particles_of_cell;
    if (others == 0) s.cell_row[s.cell_rows++] = run;
    run += others == 0 ? cells_of_row : 1;
  }
}

/// Calls row(first particle) for the first so many rows, and stretch(begin, end) for the runs before, between and
/// after them. In order: lanes past a stretch's last particle spoil what follows.
template <class Row, class Stretch>
__attribute__((always_inline)) inline void for_each_row_and_stretch(const RealScratch& s, int rows, Row&& row,
                                                                    Stretch&& stretch) {
  int begin = 0;
  for (int i = 0; i <= rows; ++i) {
    const int end = i < rows ? s.cell_row[i] : s.runs;
    stretch(begin, end);
    if (i < rows) row(s.run_begin[end]);
    begin = end + cells_of_row;
  }
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
