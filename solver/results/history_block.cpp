#include "solver/results/history_block.h"

#include <algorithm>
#include <type_traits>

namespace trajan::results {

namespace {

/// Rows of a piece into rows of all columns. `width`: a number, or a constant, by which a row is an instruction or
/// two.
template <typename Width>
void copy(const double* from, std::int64_t rows, Width width, std::size_t columns, double* to) {
  for (std::int64_t row = 0; row < rows; ++row, from += width, to += columns) std::copy_n(from, width, to);
}

void copy(const double* from, std::int64_t rows, std::size_t width, std::size_t columns, double* to) {
  switch (width) {
    case 1:
      return copy(from, rows, std::integral_constant<std::size_t, 1>(), columns, to);
    case 2:
      return copy(from, rows, std::integral_constant<std::size_t, 2>(), columns, to);
    case 3:
      return copy(from, rows, std::integral_constant<std::size_t, 3>(), columns, to);
    case 4:
      return copy(from, rows, std::integral_constant<std::size_t, 4>(), columns, to);
    default:
      return copy<std::size_t>(from, rows, width, columns, to);
  }
}

}  // namespace

void HistoryBlock::reset(std::size_t rows, std::size_t columns) {
  columns_ = columns;
  pieces_.clear();
  time.resize(rows);
  values_.resize(rows * columns);
}

double* HistoryBlock::add_piece(std::size_t column, std::size_t width) {
  const std::size_t begin = pieces_.empty() ? 0 : pieces_.back().begin + time.size() * pieces_.back().width;
  pieces_.push_back({column, width, begin});
  return values_.data() + begin;
}

void HistoryBlock::copy_rows(std::int64_t first, std::int64_t count, double* out) const {
  // So few rows at a time that they stay in a near cache until all pieces are in them: a tenth of a stream's cost.
  constexpr std::int64_t together = 32;
  for (std::int64_t row = 0; row < count; row += together) {
    for (const Piece& piece : pieces_)
      copy(values_.data() + piece.begin + static_cast<std::size_t>(first + row) * piece.width,
           std::min(together, count - row), piece.width, columns_,
           out + static_cast<std::size_t>(row) * columns_ + piece.column);
  }
}

}  // namespace trajan::results
