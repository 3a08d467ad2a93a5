#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/model/model.h"
#include "solver/results/dataset.h"
#include "solver/results/history_block.h"

namespace trajan::results {

/// The histories of a result file:
///   /time                     (rows) times of the samples; its length says how many rows are committed
///   /probes/<name>/<field>    (rows, components), attribute `components`; (rows) if it is a number
///   /energies/<column>        (rows)
///   /momentum/<column>        (rows)
///   /columns                  one row per column: name, dataset and component it lies in
/// Every group has `time` as a hard link to /time.
class Histories {
 public:
  /// Before the file goes to single-writer-multiple-reader mode.
  static Histories create(hid_t file, const Model& model);
  static Histories open(hid_t file, Dataset::Checksums checksums);

  const std::vector<std::string>& columns() const { return columns_; }
  hsize_t rows() const { return time_.rows(); }
  hsize_t chunk_rows() const { return time_.chunk_rows(); }

  /// Writes rows from `first` on, not yet their times. `values` is (rows, columns) row-major.
  void write_values(hsize_t first, std::span<const double> values);
  /// Commits the rows whose values have been written and flushed.
  void write_times(hsize_t first, std::span<const double> times) { time_.write(first, times); }
  /// Drops all rows from `rows` on. Throws if the first `file_bytes` of the file do not hold the others.
  void cut(hsize_t rows, hsize_t file_bytes);
  /// `count` committed rows from `first` on of different columns.
  void read(hsize_t first, hsize_t count, std::span<const std::size_t> selected, HistoryBlock& block);
  void refresh_rows() { time_.refresh(); }
  /// Before these rows are read from a file that is being written.
  void refresh_values(hsize_t first, hsize_t count, std::span<const std::size_t> selected);

 private:
  /// `columns[c]` is the column that component c of the dataset holds.
  struct Table {
    std::string path;
    Dataset data;
    std::vector<std::size_t> columns;
  };
  /// By column: where it is among `selected`, -1: it is not.
  std::vector<std::ptrdiff_t> places_among(std::span<const std::size_t> selected) const;
  static bool holds_any(const Table& table, std::span<const std::ptrdiff_t> places);
  void add_table(hid_t file, const std::string& path, std::vector<std::string> components, hsize_t chunk_rows);

  std::vector<std::string> columns_;
  Dataset time_;
  std::vector<Table> tables_;
};

}  // namespace trajan::results
