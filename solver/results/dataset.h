#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/results/handles.h"

namespace trajan::results {

/// A chunked dataset of rows that grows: (rows) or (rows, components).
///
/// Chunks that are not full yet are written again in place when rows are appended, and a kill may tear
/// such a write. The bits of older rows are the same before and after, so they survive it; only the
/// chunk's checksum is wrong until it is next written. Therefore a writer, and whoever reads a file that
/// was not closed, goes without checksums (`Checksums::ignore`).
class Dataset {
 public:
  enum class Checksums { verify, ignore };

  /// `components` 0: one-dimensional. Chunks of `chunk_rows` rows, with checksums (fletcher32).
  template <typename T>
  static Dataset create(hid_t parent, const std::string& name, hsize_t components, hsize_t chunk_rows) {
    return create(parent, name, stored_type<T>(), components, chunk_rows);
  }
  static Dataset create(hid_t parent, const std::string& name, hid_t type, hsize_t components, hsize_t chunk_rows);
  static Dataset open(hid_t parent, const std::string& name, Checksums checksums);

  hsize_t rows() const;
  hsize_t chunk_rows() const { return chunk_rows_; }
  hsize_t components() const { return components_; }
  /// Numbers in a row.
  hsize_t width() const { return components_ ? components_ : 1; }
  hid_t id() const { return dataset_; }

  /// Rows first … first + count; grows the dataset as needed. `values` is row-major.
  template <typename T>
  void write(hsize_t first, std::span<const T> values) {
    write(first, values.size() / width(), memory_type<T>(), values.data());
  }
  template <typename T>
  void read(hsize_t first, std::span<T> values) const {
    read(first, values.size() / width(), memory_type<T>(), values.data());
  }
  /// Rows of whatever type, as that of the dataset or a part of it.
  void write(hsize_t first, hsize_t count, hid_t type, const void* values);
  void read(hsize_t first, hsize_t count, hid_t type, void* values) const;
  /// Of doubles: rows first … end, or as many of them as lie in one chunk, row-major; valid until the next call.
  /// Several times as fast as `read`, for the chunk is taken as it lies in the file. It is kept, so that whoever
  /// reads on does not read it again. Rows before `committed` are in the file for good.
  std::span<const double> rows_from(hsize_t first, hsize_t end, hsize_t committed);
  /// Whether `rows_from` need not ask the file for these.
  bool holds(hsize_t first, hsize_t end) const { return first >= held_.first && end <= held_.end; }
  /// Drops the rows from `kept` on, and makes the checksum of the last chunk that stays right. Throws if
  /// the first `file_bytes` of the file do not hold the rows before.
  template <typename T>
  void cut(hsize_t kept, hsize_t file_bytes) {
    require_rows(kept, file_bytes);
    const hsize_t chunk_start = kept / chunk_rows_ * chunk_rows_;
    std::vector<T> last((kept - chunk_start) * width());
    read<T>(chunk_start, last);
    write<T>(chunk_start, last);
    resize(kept);
  }
  /// Asks the file again what its writer has written since.
  void refresh();

 private:
  /// A chunk and its checksum, of which rows first … end were committed when it was read.
  struct HeldChunk {
    std::vector<double> values;
    hsize_t first = 0, end = 0;
  };
  void hold_chunk(hsize_t first, hsize_t committed);
  Handle select(hsize_t first, hsize_t count) const;
  Handle memory_space(hsize_t count) const;
  void require_rows(hsize_t needed, hsize_t file_bytes) const;
  void resize(hsize_t rows);

  std::string name_;
  Handle dataset_;
  Checksums checksums_ = Checksums::ignore;
  HeldChunk held_;
  hsize_t components_ = 0;
  hsize_t chunk_rows_ = 1;
};

}  // namespace trajan::results
