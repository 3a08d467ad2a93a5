#include "server/history_stream.h"

#include <algorithm>

#include "server/store_jobs.h"
#include "solver/results/results.h"

namespace trajan {

namespace {

[[noreturn]] void throw_unknown_column(const std::string& wanted, const std::vector<std::string>& columns) {
  std::string message = "there is no column \"" + wanted + "\"; there are:";
  for (const std::string& column : columns) message += " " + column;
  throw ServiceError(grpc::StatusCode::NOT_FOUND, "NO_SUCH_COLUMN", message);
}

/// Indices of the columns that are named, or have a name as a dotted prefix, in the file's order.
std::vector<std::size_t> select_columns(const std::vector<std::string>& columns,
                                        const google::protobuf::RepeatedPtrField<std::string>& wanted) {
  std::vector<char> selected(columns.size(), wanted.empty());
  for (const std::string& name : wanted) {
    bool found = false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] != name && !columns[i].starts_with(name + ".")) continue;
      selected[i] = found = true;
    }
    if (!found) throw_unknown_column(name, columns);
  }
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (selected[i]) indices.push_back(i);
  }
  return indices;
}

class HistoryStream final : public Stream<v1::StreamHistoryResponse> {
 public:
  HistoryStream(grpc::CallbackServerContext* context, v1::StreamHistoryRequest request, std::int64_t job,
                store::Store& store, Hub& hub, HistoryReading& reading, std::filesystem::path jobs_directory)
      : Stream(context, job, hub, reading.queue),
        request_(std::move(request)),
        store_(store),
        readers_(reading.readers),
        jobs_directory_(std::move(jobs_directory)),
        row_(request_.first_row()) {}

 private:
  Next next(v1::StreamHistoryResponse& response) final {
    if (sent_ < block_.rows()) {
      fill(response);
      return Next::write;
    }
    // In this order: rows that were written before the job ended are seen after it.
    const v1::Job now = store_.read([&](store::Database& database) { return store::get_job(database, job()); });
    const bool ended = store::has_ended(now.state());
    directory_ = store::files_of(jobs_directory_, now);
    if (!readable()) {
      if (request_.follow() && !ended) return Next::wait;
      throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "NO_HISTORY",
                         "job " + now.job_id() + " has no history" + (ended ? "" : " yet"));
    }
    const bool first = selected_.empty();
    if (!read(response, now, ended)) return Next::wait;
    if (first || response.time_size() > 0) return Next::write;
    return request_.follow() && !ended ? Next::wait : Next::finish;
  }

  bool readable() const {
    return std::filesystem::exists(directory_ / results::result_name) ||
           std::filesystem::exists(directory_ / results::partial_name);
  }

  /// Fills in the next rows, and the columns if this is the first message. False if the file cannot be
  /// read now: it is just being created, or repaired after a worker was lost.
  bool read(v1::StreamHistoryResponse& response, const v1::Job& now, bool ended) {
    if (!reader_) reader_ = readers_.share(directory_);
    try {
      results::HistoryReader& reader = reader_->get(now.attempts(), ended);
      if (selected_.empty()) {
        selected_ = select_columns(reader.columns(), request_.columns());
        for (const std::size_t index : selected_) response.add_columns(reader.columns()[index]);
      }
      read_rows(reader);
      fill(response);
      // Opened after the attempt began but before it repaired the file: open it again next time.
      if (block_.rows() == 0 && row_ < now.progress().rows()) reader_->close();
      return true;
    } catch (const ServiceError&) {
      throw;
    } catch (const std::runtime_error&) {
      reader_->close();
      block_ = {};
      sent_ = 0;
      if (ended && ++failures_ > 1) throw;
      if (ended) return read(response, now, ended);
      return false;
    }
  }

  /// Reads what is left of the file's chunks, if that is not too much, for the file has each column by itself; and
  /// a message's worth at least.
  void read_rows(results::HistoryReader& reader) {
    constexpr std::int64_t block_bytes = 16 << 20;
    const std::int64_t chunk = reader.chunk_rows();
    reader.read(row_, std::clamp(chunk - row_ % chunk, rows_of(message_bytes), rows_of(block_bytes)), selected_,
                block_);
    sent_ = 0;
  }

  /// The next rows of the block.
  void fill(v1::StreamHistoryResponse& response) {
    const auto rows = static_cast<int>(std::min(rows_of(message_bytes), block_.rows() - sent_));
    const int numbers = rows * static_cast<int>(selected_.size());
    response.set_first_row(row_);
    response.mutable_time()->Add(block_.time.begin() + sent_, block_.time.begin() + sent_ + rows);
    response.mutable_values()->Reserve(numbers);
    block_.copy_rows(sent_, rows, response.mutable_values()->AddNAlreadyReserved(numbers));
    row_ += rows;
    sent_ += rows;
  }

  /// At least one.
  std::int64_t rows_of(std::int64_t bytes) const {
    return std::max<std::int64_t>(
        1, bytes / ((std::ssize(selected_) + 1) * static_cast<std::int64_t>(sizeof(double))));
  }

  /// Of each message but the last: a part of what a client takes by default, 4 MiB.
  static constexpr std::int64_t message_bytes = 1 << 20;

  const v1::StreamHistoryRequest request_;
  store::Store& store_;
  HistoryReaders& readers_;
  const std::filesystem::path jobs_directory_;
  std::filesystem::path directory_;  ///< of the file
  std::shared_ptr<SharedReader> reader_;
  std::vector<std::size_t> selected_;
  results::HistoryBlock block_;  ///< what was read last
  std::int64_t sent_ = 0;        ///< of its rows
  std::int64_t row_;             ///< the next one
  int failures_ = 0;
};

}  // namespace

grpc::ServerWriteReactor<v1::StreamHistoryResponse>* stream_history(grpc::CallbackServerContext* context,
                                                                    const v1::StreamHistoryRequest& request,
                                                                    store::Store& store, Hub& hub,
                                                                    HistoryReading& reading,
                                                                    const std::filesystem::path& jobs_directory) {
  const std::int64_t job = store::job_number(request.job_id());
  if (request.first_row() < 0) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "FIRST_ROW", "first_row must not be negative");
  }
  return Stream<v1::StreamHistoryResponse>::start(
      std::make_shared<HistoryStream>(context, request, job, store, hub, reading, jobs_directory));
}

}  // namespace trajan
