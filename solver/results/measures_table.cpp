#include "solver/results/measures_table.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace trajan::results {

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

struct MeasureRow {
  const char* name;
  const char* quantity;
  double value;
  double exact;
  double error;
  double tolerance;
  const char* source;
};

const std::string measures_access = "access /measures";

void insert_numbers(hid_t type) {
  check(H5Tinsert(type, "value", HOFFSET(MeasureRow, value), H5T_NATIVE_DOUBLE), measures_access);
  check(H5Tinsert(type, "exact", HOFFSET(MeasureRow, exact), H5T_NATIVE_DOUBLE), measures_access);
  check(H5Tinsert(type, "error", HOFFSET(MeasureRow, error), H5T_NATIVE_DOUBLE), measures_access);
  check(H5Tinsert(type, "tolerance", HOFFSET(MeasureRow, tolerance), H5T_NATIVE_DOUBLE), measures_access);
}

Handle measure_row_type() {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(MeasureRow)), H5Tclose, measures_access);
  const Handle text = string_type();
  check(H5Tinsert(type, "name", HOFFSET(MeasureRow, name), text), measures_access);
  check(H5Tinsert(type, "quantity", HOFFSET(MeasureRow, quantity), text), measures_access);
  insert_numbers(type);
  check(H5Tinsert(type, "source", HOFFSET(MeasureRow, source), text), measures_access);
  return type;
}

/// The members that are numbers: writing them leaves the texts as they are.
Handle numbers_type() {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(MeasureRow)), H5Tclose, measures_access);
  insert_numbers(type);
  return type;
}

Handle open_measures(hid_t file) { return {H5Dopen2(file, "measures", H5P_DEFAULT), H5Dclose, measures_access}; }

std::optional<double> present(double value) {
  return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

/// All rows with their texts, which live until destroyed.
class Rows {
 public:
  explicit Rows(hid_t file) : type_(measure_row_type()) {
    const Handle dataset = open_measures(file);
    space_ = Handle(H5Dget_space(dataset), H5Sclose, measures_access);
    const hssize_t count = H5Sget_simple_extent_npoints(space_);
    if (count < 0) throw std::runtime_error("cannot " + measures_access);
    rows.resize(static_cast<std::size_t>(count));
    if (!rows.empty()) check(H5Dread(dataset, type_, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), measures_access);
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  ~Rows() { H5Dvlen_reclaim(type_, space_, H5P_DEFAULT, rows.data()); }
  std::vector<MeasureRow> rows;

 private:
  Handle type_;
  Handle space_;
};

}  // namespace

void create_measures(hid_t file, const Model& model) {
  std::vector<MeasureRow> rows;
  for (const Measure& measure : model.measures)
    rows.push_back({measure.name.c_str(), measure.quantity.c_str(), absent, measure.exact.value_or(absent), absent,
                    measure.tolerance.value_or(absent), measure.source.c_str()});
  const Handle type = measure_row_type();
  const hsize_t size = rows.size();
  Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose, measures_access);
  Handle dataset(H5Dcreate2(file, "measures", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                 measures_access);
  if (!rows.empty()) check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), measures_access);
}

void write_measures(hid_t file, std::span<const MeasureValue> measures) {
  if (measures.empty()) return;
  Rows table(file);
  for (MeasureRow& row : table.rows)
    for (const MeasureValue& measure : measures)
      if (measure.name == row.name) {
        row.value = measure.value;
        row.exact = measure.exact.value_or(absent);
        row.error = measure.error.value_or(absent);
        row.tolerance = measure.tolerance.value_or(absent);
      }
  check(H5Dwrite(open_measures(file), numbers_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.rows.data()),
        measures_access);
}

std::vector<MeasureValue> read_measures(hid_t file) {
  const Rows table(file);
  std::vector<MeasureValue> measures;
  for (const MeasureRow& row : table.rows)
    if (!std::isnan(row.value))
      measures.push_back({row.name, row.quantity, row.value, present(row.exact), present(row.error),
                          present(row.tolerance), row.source});
  return measures;
}

}  // namespace trajan::results
