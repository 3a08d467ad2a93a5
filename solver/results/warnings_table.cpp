#include "solver/results/warnings_table.h"

#include <algorithm>
#include <array>

namespace trajan::results {

namespace {

/// Texts end with a zero.
struct Row {
  std::array<char, 128> name;
  std::array<char, 512> cause, remedy;
  std::int64_t step;
  double time;
  std::int64_t particle;
};

const std::string what = "access /warnings";

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type, size), what);
  check(H5Tset_cset(type, H5T_CSET_UTF8), what);
  return type;
}

Handle row_type() {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(Row)), H5Tclose, what);
  check(H5Tinsert(type, "name", HOFFSET(Row, name), text_type(sizeof(Row::name))), what);
  check(H5Tinsert(type, "cause", HOFFSET(Row, cause), text_type(sizeof(Row::cause))), what);
  check(H5Tinsert(type, "remedy", HOFFSET(Row, remedy), text_type(sizeof(Row::remedy))), what);
  check(H5Tinsert(type, "step", HOFFSET(Row, step), stored_type<std::int64_t>()), what);
  check(H5Tinsert(type, "time", HOFFSET(Row, time), stored_type<double>()), what);
  check(H5Tinsert(type, "particle", HOFFSET(Row, particle), stored_type<std::int64_t>()), what);
  return type;
}

/// As much as there is room for, in whole characters of UTF-8.
template <std::size_t size>
std::array<char, size> fitted(const std::string& text) {
  std::size_t end = std::min(text.size(), size - 1);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  std::array<char, size> fixed{};
  std::copy_n(text.begin(), end, fixed.begin());
  return fixed;
}

}  // namespace

WarningsTable WarningsTable::create(hid_t file) {
  return WarningsTable(Dataset::create(file, "warnings", row_type(), 0, most_warnings));
}

WarningsTable WarningsTable::open(hid_t file, Dataset::Checksums checksums) {
  WarningsTable table(Dataset::open(file, "warnings", checksums));
  std::vector<Row> rows(table.rows_.rows());
  table.rows_.read(0, rows.size(), row_type(), rows.data());
  for (Row& row : rows) {
    row.name.back() = row.cause.back() = row.remedy.back() = 0;
    table.warnings_.push_back(
        {row.name.data(), row.step, row.time, row.particle, {}, row.cause.data(), row.remedy.data()});
  }
  return table;
}

bool WarningsTable::add(const Warning& warning) {
  const auto is_same = [&](const Warning& known) { return known.name == warning.name; };
  if (warnings_.size() == most_warnings || std::ranges::any_of(warnings_, is_same)) return false;
  const Row row{fitted<sizeof(Row::name)>(warning.name),
                fitted<sizeof(Row::cause)>(warning.cause),
                fitted<sizeof(Row::remedy)>(warning.remedy),
                warning.step,
                warning.time,
                warning.particle};
  rows_.write(warnings_.size(), 1, row_type(), &row);
  warnings_.push_back(warning);
  return true;
}

}  // namespace trajan::results
