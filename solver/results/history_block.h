#pragma once

#include <cstdint>
#include <vector>

namespace trajan::results {

/// Rows of some columns of the histories. The file keeps columns apart, or a few together, such as the components
/// of a vector. So does this, until rows are asked for.
class HistoryBlock {
 public:
  /// Makes place for so many, and forgets what there was.
  void reset(std::size_t rows, std::size_t columns);
  /// Where to put `width` columns from `column` on, (rows, width) row-major. Each column belongs to one piece.
  double* add_piece(std::size_t column, std::size_t width);
  std::int64_t rows() const { return std::ssize(time); }
  /// Puts rows first … first + count into `out`, (count, columns) row-major.
  void copy_rows(std::int64_t first, std::int64_t count, double* out) const;

  std::vector<double> time;  ///< (rows)

 private:
  struct Piece {
    std::size_t column, width, begin;
  };
  std::size_t columns_ = 0;
  std::vector<Piece> pieces_;
  std::vector<double> values_;  ///< one piece after the other
};

}  // namespace trajan::results
