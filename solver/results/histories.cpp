#include "solver/results/histories.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <stdexcept>

namespace trajan::results {

namespace {

/// A row of /columns.
struct ColumnPlace {
  const char* column;
  const char* dataset;
  std::int64_t component;
};

Handle column_place_type() {
  const std::string what = "describe the columns";
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(ColumnPlace)), H5Tclose, what);
  const Handle text = string_type();
  check(H5Tinsert(type, "column", HOFFSET(ColumnPlace, column), text), what);
  check(H5Tinsert(type, "dataset", HOFFSET(ColumnPlace, dataset), text), what);
  check(H5Tinsert(type, "component", HOFFSET(ColumnPlace, component), H5T_NATIVE_INT64), what);
  return type;
}

void write_places(hid_t file, const std::vector<ColumnPlace>& places) {
  const std::string what = "write /columns";
  const Handle type = column_place_type();
  const hsize_t size = places.size();
  Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, what);
  Handle dataset(H5Dcreate2(file, "columns", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose, what);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, places.data()), what);
}

struct OwnedColumnPlace {
  std::string column;
  std::string dataset;
  std::size_t component;
};

std::vector<OwnedColumnPlace> read_places(hid_t file) {
  const std::string what = "read /columns";
  const Handle type = column_place_type();
  Handle dataset(H5Dopen2(file, "columns", H5P_DEFAULT), H5Dclose, what);
  Handle space(H5Dget_space(dataset), H5Sclose, what);
  const hssize_t size = H5Sget_simple_extent_npoints(space);
  if (size < 0) throw std::runtime_error("cannot " + what);
  std::vector<ColumnPlace> places(static_cast<std::size_t>(size));
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, places.data()), what);
  std::vector<OwnedColumnPlace> owned;
  for (const ColumnPlace& place : places)
    owned.push_back({place.column ? place.column : "", place.dataset ? place.dataset : "",
                     static_cast<std::size_t>(place.component)});
  check(H5Dvlen_reclaim(type, space, H5P_DEFAULT, places.data()), what);
  return owned;
}

/// A chunk is written again with every commit until it is full, so it must not be large; a long history
/// must not fall into too many.
hsize_t rows_per_chunk(std::int64_t samples) {
  return static_cast<hsize_t>(std::clamp<std::int64_t>(samples + 1, 16, 4096));
}

/// Calls `take(row, piece)`, where `piece` is rows first + row … of the dataset, row-major, chunk by chunk.
template <typename Take>
void for_pieces(Dataset& data, hsize_t first, hsize_t count, hsize_t committed, const Take& take) {
  for (hsize_t row = 0; row < count;) {
    const std::span<const double> piece = data.rows_from(first + row, first + count, committed);
    take(row, piece);
    row += piece.size() / data.width();
  }
}

/// Components of a dataset that are wanted, and next to each other also there.
struct Run {
  std::size_t component, width;
  double* to;  ///< (rows, width)
};

void copy_run(std::span<const double> rows, std::size_t components, const Run& run, hsize_t row) {
  double* to = run.to + row * run.width;
  if (run.width == components) {
    std::ranges::copy(rows, to);
    return;
  }
  for (std::size_t i = run.component; i < rows.size(); i += components, to += run.width)
    std::copy_n(rows.data() + i, run.width, to);
}

/// `places`: of each component among the columns of the block; -1: none.
std::vector<Run> runs_of(std::span<const std::ptrdiff_t> places, HistoryBlock& block) {
  std::vector<Run> runs;
  for (std::size_t c = 0; c < places.size();) {
    std::size_t end = c + 1;
    while (end < places.size() && places[c] >= 0 && places[end] == places[end - 1] + 1) ++end;
    if (places[c] >= 0)
      runs.push_back({c, end - c, block.add_piece(static_cast<std::size_t>(places[c]), end - c)});
    c = end;
  }
  return runs;
}

void link_time(hid_t file, const std::string& group) {
  check(H5Lcreate_hard(file, "/time", file, (group + "/time").c_str(), H5P_DEFAULT, H5P_DEFAULT),
        "link " + group + "/time");
}

}  // namespace

void Histories::add_table(hid_t file, const std::string& path, std::vector<std::string> components,
                          hsize_t chunk_rows) {
  Table table{path, Dataset::create<double>(file, path, components.size(), chunk_rows), {}};
  const std::size_t width = std::max<std::size_t>(components.size(), 1);
  const std::size_t first = tables_.empty() ? 0 : tables_.back().columns.back() + 1;
  for (std::size_t c = 0; c < width; ++c) table.columns.push_back(first + c);
  if (!components.empty()) set_attribute(table.data.id(), "components", components);
  tables_.push_back(std::move(table));
}

Histories Histories::create(hid_t file, const Model& model) {
  Histories histories;
  histories.columns_ = history_columns(model);
  const hsize_t chunk_rows = rows_per_chunk(model.outputs.samples);
  histories.time_ = Dataset::create<double>(file, "time", 0, chunk_rows);
  make_group(file, "probes");
  for (const Probe& probe : model.outputs.probes) {
    const std::string group = "/probes/" + probe.name;
    make_group(file, group);
    link_time(file, group);
    for (const RecordedField& field : probe.fields) {
      histories.add_table(file, group + "/" + field.name, {field.components.begin(), field.components.end()},
                          chunk_rows);
    }
  }
  // What follows the probes is named "<group>.<column>".
  std::string group;
  for (std::size_t c = histories.tables_.empty() ? 0 : histories.tables_.back().columns.back() + 1;
       c < histories.columns_.size(); ++c) {
    const std::string& name = histories.columns_[c];
    const std::size_t dot = name.find('.');
    if (std::string this_group = std::string("/").append(name, 0, dot); this_group != group) {
      group = std::move(this_group);
      make_group(file, group);
      link_time(file, group);
    }
    histories.add_table(file, group + "/" + name.substr(dot + 1), {}, chunk_rows);
  }
  std::vector<ColumnPlace> places;
  for (const Table& table : histories.tables_)
    for (std::size_t component = 0; component < table.columns.size(); ++component)
      places.push_back({histories.columns_[table.columns[component]].c_str(), table.path.c_str(),
                        static_cast<std::int64_t>(component)});
  assert(places.size() == histories.columns_.size());
  write_places(file, places);
  return histories;
}

Histories Histories::open(hid_t file, Dataset::Checksums checksums) {
  Histories histories;
  histories.time_ = Dataset::open(file, "time", checksums);
  std::map<std::string, std::size_t> table_of;
  for (const OwnedColumnPlace& place : read_places(file)) {
    const auto [entry, is_new] = table_of.try_emplace(place.dataset, histories.tables_.size());
    if (is_new) {
      Table table{place.dataset, Dataset::open(file, place.dataset, checksums), {}};
      table.columns.resize(std::max<hsize_t>(table.data.components(), 1));
      histories.tables_.push_back(std::move(table));
    }
    histories.tables_[entry->second].columns.at(place.component) = histories.columns_.size();
    histories.columns_.push_back(place.column);
  }
  return histories;
}

void Histories::write_values(hsize_t first, std::span<const double> values) {
  const std::size_t stride = columns_.size();
  const std::size_t count = values.size() / stride;
  std::vector<double> block;
  for (Table& table : tables_) {
    const std::size_t width = table.columns.size();
    block.resize(count * width);
    for (std::size_t row = 0; row < count; ++row)
      for (std::size_t c = 0; c < width; ++c) block[row * width + c] = values[row * stride + table.columns[c]];
    table.data.write<double>(first, block);
  }
}

void Histories::cut(hsize_t rows, hsize_t file_bytes) {
  for (Table& table : tables_) table.data.cut<double>(rows, file_bytes);
  time_.cut<double>(rows, file_bytes);
}

std::vector<std::ptrdiff_t> Histories::places_among(std::span<const std::size_t> selected) const {
  std::vector<std::ptrdiff_t> places(columns_.size(), -1);
  for (std::size_t s = 0; s < selected.size(); ++s) places[selected[s]] = static_cast<std::ptrdiff_t>(s);
  return places;
}

bool Histories::holds_any(const Table& table, std::span<const std::ptrdiff_t> places) {
  return std::ranges::any_of(table.columns, [&](std::size_t column) { return places[column] >= 0; });
}

void Histories::refresh_values(hsize_t first, hsize_t count, std::span<const std::size_t> selected) {
  if (count == 0) return;
  const std::vector<std::ptrdiff_t> places = places_among(selected);
  for (Table& table : tables_)
    if (holds_any(table, places) && !table.data.holds(first, first + count)) table.data.refresh();
}

void Histories::read(hsize_t first, hsize_t count, std::span<const std::size_t> selected, HistoryBlock& block) {
  const hsize_t committed = rows();
  const std::vector<std::ptrdiff_t> places = places_among(selected);
  block.reset(count, selected.size());
  for_pieces(time_, first, count, committed, [&](hsize_t row, std::span<const double> piece) {
    std::ranges::copy(piece, block.time.data() + row);
  });
  for (Table& table : tables_) {
    std::vector<std::ptrdiff_t> wanted;
    for (const std::size_t column : table.columns) wanted.push_back(places[column]);
    const std::vector<Run> runs = runs_of(wanted, block);
    if (runs.empty()) continue;
    for_pieces(table.data, first, count, committed, [&](hsize_t row, std::span<const double> piece) {
      for (const Run& run : runs) copy_run(piece, table.columns.size(), run, row);
    });
  }
}

}  // namespace trajan::results
