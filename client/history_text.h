#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/history_stream.h"
#include "client/table.h"

namespace trajan::client {

/// Rows of a history as lines of CSV or JSON. Numbers are the shortest text that reads back to the same bits; what
/// is not finite is `null` in JSON.
class HistoryText {
 public:
  /// `format`: csv or jsonl.
  HistoryText(OutputFormat format, const std::vector<std::string>& columns);
  /// The line of CSV that names the columns.
  std::string heading() const;
  /// Valid until the next call.
  std::string_view lines(const HistoryRows& rows);

 private:
  char* csv_line(char* at, double time, std::span<const double> values) const;
  char* json_line(char* at, std::int64_t row, double time, std::span<const double> values) const;

  OutputFormat format_;
  std::vector<std::string> labels_;  ///< what stands before each number, or in the heading
  std::vector<char> text_;
};

/// Writes a history as CSV: `time` and the columns, then one line for each row.
void write_history_csv(std::ostream& out, const History& history);

}  // namespace trajan::client
