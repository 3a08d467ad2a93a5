#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "client/connection.h"
#include "client/interrupt.h"

namespace trajan::client {

struct HistoryRequest {
  std::string job_id;
  std::vector<std::string> columns;  ///< names or dotted prefixes; empty: all
  std::int64_t first_row = 0;
  bool follow = false;
};

/// Rows as they come.
struct HistoryRows {
  std::int64_t first_row = 0;
  std::span<const double> time;
  std::span<const double> values;  ///< (time.size(), columns.size()) row-major
};

class HistoryConsumer {
 public:
  virtual ~HistoryConsumer() = default;
  /// Once, before the first rows.
  virtual void columns(const std::vector<std::string>& names) = 0;
  virtual void rows(const HistoryRows& rows) = 0;
};

/// Reads a history to its end, over lost connections, every row once and in order. Returns the number of the
/// row after the last one. An interrupt ends it early. Throws CallError.
std::int64_t stream_history(Connection& connection, const HistoryRequest& request, InterruptWatch* interrupt,
                            HistoryConsumer& consumer);

/// A history in memory.
struct History {
  std::vector<std::string> columns;
  std::vector<double> time;
  std::vector<std::vector<double>> values;  ///< one array for each column
};

History read_history(Connection& connection, const HistoryRequest& request);
/// Reads what `trajan history` wrote as CSV. Throws CommandError.
History read_history_csv(const std::string& file);

}  // namespace trajan::client
