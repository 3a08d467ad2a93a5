#include "client/history_stream.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>

namespace trajan::client {
namespace {

struct Cursor {
  std::int64_t next_row = 0;
  std::size_t columns = 0;
  bool has_columns = false;
  std::chrono::steady_clock::time_point last_heard = std::chrono::steady_clock::now();
};

void take(const v1::StreamHistoryResponse& response, Cursor& cursor, HistoryConsumer& consumer) {
  cursor.last_heard = std::chrono::steady_clock::now();
  if (response.columns_size() > 0 && !cursor.has_columns) {
    cursor.has_columns = true;
    cursor.columns = static_cast<std::size_t>(response.columns_size());
    consumer.columns({response.columns().begin(), response.columns().end()});
  }
  if (response.time_size() == 0) return;
  consumer.rows({response.first_row(),
                 {response.time().data(), static_cast<std::size_t>(response.time_size())},
                 {response.values().data(), static_cast<std::size_t>(response.values_size())}});
  cursor.next_row = response.first_row() + response.time_size();
}

/// One connection. False if it was lost and may come back.
bool stream_once(Connection& connection, const HistoryRequest& asked, InterruptWatch* interrupt, Cursor& cursor,
                 HistoryConsumer& consumer) {
  grpc::ClientContext context;
  v1::StreamHistoryRequest request;
  request.set_job_id(asked.job_id);
  request.mutable_columns()->Assign(asked.columns.begin(), asked.columns.end());
  request.set_first_row(cursor.next_row);
  request.set_follow(asked.follow);
  const auto reader = connection.jobs().StreamHistory(&context, request);
  const InterruptReaction reaction(interrupt, [&context] { context.TryCancel(); });
  v1::StreamHistoryResponse response;
  while (reader->Read(&response)) take(response, cursor, consumer);
  const grpc::Status status = reader->Finish();
  if (interrupt != nullptr && interrupt->interrupted()) return true;
  if (may_come_back(status) && std::chrono::steady_clock::now() - cursor.last_heard < silence_allowed) {
    return false;
  }
  require_ok(status, context, connection.address());
  return true;
}

/// Collects a history in memory.
class Collector : public HistoryConsumer {
 public:
  void columns(const std::vector<std::string>& names) override {
    history.columns = names;
    history.values.resize(names.size());
  }
  void rows(const HistoryRows& rows) override {
    history.time.insert(history.time.end(), rows.time.begin(), rows.time.end());
    const std::size_t width = history.columns.size();
    for (std::size_t c = 0; c < width; ++c)
      for (std::size_t i = c; i < rows.values.size(); i += width) history.values[c].push_back(rows.values[i]);
  }
  History history;
};

}  // namespace

std::int64_t stream_history(Connection& connection, const HistoryRequest& request, InterruptWatch* interrupt,
                            HistoryConsumer& consumer) {
  Cursor cursor;
  cursor.next_row = request.first_row;
  for (Backoff backoff; !stream_once(connection, request, interrupt, cursor, consumer); backoff.pause()) {
  }
  return cursor.next_row;
}

History read_history(Connection& connection, const HistoryRequest& request) {
  Collector collector;
  stream_history(connection, request, nullptr, collector);
  return std::move(collector.history);
}

History read_history_csv(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line) || !line.starts_with("time")) {
    throw CommandError(ExitCode::not_found, fmt::format("\"{}\" is not a history in CSV", file),
                       "the first line must name the columns, starting with time");
  }
  History history;
  std::istringstream names(line);
  for (std::string name; std::getline(names, name, ',');) history.columns.push_back(name);
  history.columns.erase(history.columns.begin());
  history.values.resize(history.columns.size());
  for (int number = 2; std::getline(in, line); ++number) {
    const char* at = line.data();
    const char* end = at + line.size();
    for (std::size_t i = 0; i <= history.columns.size(); ++i) {
      double value = 0;
      const auto [next, error] = std::from_chars(at, end, value);
      if (error != std::errc() || (i < history.columns.size() && (next == end || *next != ','))) {
        throw CommandError(ExitCode::usage, fmt::format("{}:{}: error: expected {} numbers with commas between",
                                                        file, number, history.columns.size() + 1));
      }
      (i == 0 ? history.time : history.values[i - 1]).push_back(value);
      at = next + 1;
    }
  }
  return history;
}

}  // namespace trajan::client
