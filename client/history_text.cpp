#include "client/history_text.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace trajan::client {
namespace {

/// Of a number as text: -1.7976931348623157e+308, or a row's number of 20 digits.
constexpr std::size_t longest_number = 24;

/// Half of what a format that is read while the program runs takes.
char* put(char* at, double value) { return fmt::format_to(at, FMT_COMPILE("{}"), value); }

char* put(char* at, std::string_view text) { return std::ranges::copy(text, at).out; }

char* put_json(char* at, double value) { return std::isfinite(value) ? put(at, value) : put(at, "null"); }

}  // namespace

HistoryText::HistoryText(OutputFormat format, const std::vector<std::string>& columns) : format_(format) {
  for (const std::string& column : columns)
    labels_.push_back(format == OutputFormat::csv ? ',' + csv_text(column) : ',' + json_string(column) + ':');
}

std::string HistoryText::heading() const {
  std::string line = "time";
  for (const std::string& label : labels_) line += label;
  return line + '\n';
}

std::string_view HistoryText::lines(const HistoryRows& rows) {
  constexpr std::string_view json_frame = "{\"row\":,\"time\":}\n";
  std::size_t longest = json_frame.size() + 2 * longest_number;
  for (const std::string& label : labels_) longest += label.size() + longest_number;
  text_.resize(std::max(text_.size(), rows.time.size() * longest));
  char* at = text_.data();
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    const auto values = rows.values.subspan(i * labels_.size(), labels_.size());
    at = format_ == OutputFormat::csv
             ? csv_line(at, rows.time[i], values)
             : json_line(at, rows.first_row + static_cast<std::int64_t>(i), rows.time[i], values);
  }
  return {text_.data(), at};
}

char* HistoryText::csv_line(char* at, double time, std::span<const double> values) const {
  at = put(at, time);
  for (const double value : values) {
    *at++ = ',';
    at = put(at, value);
  }
  *at++ = '\n';
  return at;
}

char* HistoryText::json_line(char* at, std::int64_t row, double time, std::span<const double> values) const {
  at = fmt::format_to(at, FMT_COMPILE("{{\"row\":{},\"time\":"), row);
  at = put_json(at, time);
  for (std::size_t i = 0; i < values.size(); ++i) at = put_json(put(at, labels_[i]), values[i]);
  return put(at, "}\n");
}

void write_history_csv(std::ostream& out, const History& history) {
  HistoryText text(OutputFormat::csv, history.columns);
  out << text.heading();
  std::vector<double> row(history.columns.size());
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = history.values[c][i];
    out << text.lines({static_cast<std::int64_t>(i), {&history.time[i], 1}, row});
  }
}

}  // namespace trajan::client
