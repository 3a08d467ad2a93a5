#include "solver/results/warnings_table.h"

#include <algorithm>
#include <array>

namespace trajan::results {

namespace {

/// Texts end with a zero.
struct WarningRow {
  std::array<char, 128> name;
  std::array<char, 512> cause, remedy;
  std::int64_t step;
  double time;
  std::int64_t particle;
};

const std::string warnings_access = "access /warnings";

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, warnings_access);
  check(H5Tset_size(type, size), warnings_access);
  check(H5Tset_cset(type, H5T_CSET_UTF8), warnings_access);
  return type;
}

Handle warning_row_type() {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(WarningRow)), H5Tclose, warnings_access);
  check(H5Tinsert(type, "name", HOFFSET(WarningRow, name), text_type(sizeof(WarningRow::name))), warnings_access);
  check(H5Tinsert(type, "cause", HOFFSET(WarningRow, cause), text_type(sizeof(WarningRow::cause))),
        warnings_access);
  check(H5Tinsert(type, "remedy", HOFFSET(WarningRow, remedy), text_type(sizeof(WarningRow::remedy))),
        warnings_access);
  check(H5Tinsert(type, "step", HOFFSET(WarningRow, step), stored_type<std::int64_t>()), warnings_access);
  check(H5Tinsert(type, "time", HOFFSET(WarningRow, time), stored_type<double>()), warnings_access);
  check(H5Tinsert(type, "particle", HOFFSET(WarningRow, particle), stored_type<std::int64_t>()), warnings_access);
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
  return WarningsTable(Dataset::create(file, "warnings", warning_row_type(), 0, most_warnings));
}

WarningsTable WarningsTable::open(hid_t file, Dataset::Checksums checksums) {
  WarningsTable table(Dataset::open(file, "warnings", checksums));
  std::vector<WarningRow> rows(table.rows_.rows());
  table.rows_.read(0, rows.size(), warning_row_type(), rows.data());
  for (WarningRow& row : rows) {
    row.name.back() = row.cause.back() = row.remedy.back() = 0;
    table.warnings_.push_back(
        {row.name.data(), row.step, row.time, row.particle, {}, row.cause.data(), row.remedy.data()});
  }
  return table;
}

bool WarningsTable::add(const Warning& warning) {
  const auto is_same = [&](const Warning& known) { return known.name == warning.name; };
  if (warnings_.size() == most_warnings || std::ranges::any_of(warnings_, is_same)) return false;
  const WarningRow row{fitted<sizeof(WarningRow::name)>(warning.name),
                       fitted<sizeof(WarningRow::cause)>(warning.cause),
                       fitted<sizeof(WarningRow::remedy)>(warning.remedy),
                       warning.step,
                       warning.time,
                       warning.particle};
  rows_.write(warnings_.size(), 1, warning_row_type(), &row);
  warnings_.push_back(warning);
  return true;
}

}  // namespace trajan::results
