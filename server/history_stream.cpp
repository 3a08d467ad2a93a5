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
                store::Store& store, Hub& hub, TaskQueue& queue, std::filesystem::path directory)
      : Stream(context, job, hub, queue),
        request_(std::move(request)),
        store_(store),
        directory_(std::move(directory)),
        row_(request_.first_row()) {}

 private:
  Next next(v1::StreamHistoryResponse& response) final {
    // In this order: rows that were written before the job ended are seen after it.
    const v1::Job now = read_job();
    const bool ended = store::has_ended(now.state());
    if (reader_ && now.attempts() != attempt_) reader_.reset();
    attempt_ = now.attempts();
    if (!open(ended)) {
      if (request_.follow() && !ended) return Next::wait;
      throw ServiceError(grpc::StatusCode::FAILED_PRECONDITION, "NO_HISTORY",
                         "job " + now.job_id() + " has no history" + (ended ? "" : " yet"));
    }
    const bool rows = read_rows(response, ended);
    const bool columns = reader_ && !columns_sent_;
    if (columns) add_columns(response);
    if (rows || columns) return Next::write;
    return request_.follow() && !ended ? Next::wait : Next::finish;
  }

  /// False if there is no file that can be read now.
  bool open(bool ended) {
    if (reader_) return true;
    try {
      reader_ = results::HistoryReader::open(directory_);
    } catch (const std::runtime_error&) {
      // A file that is about to be created or repaired can be read a little later.
      if (ended && std::filesystem::exists(directory_ / results::result_name)) throw;
      return false;
    }
    selected_ = select_columns(reader_->columns(), request_.columns());
    return true;
  }

  /// Fills in the next rows, if there are any.
  bool read_rows(v1::StreamHistoryResponse& response, bool ended) {
    constexpr std::int64_t most_bytes = 256 * 1024;
    const auto row_bytes = static_cast<std::int64_t>((selected_.size() + 1) * sizeof(double));
    try {
      const std::int64_t count =
          std::min(reader_->rows() - row_, std::max<std::int64_t>(1, most_bytes / row_bytes));
      response.set_first_row(row_);
      if (count <= 0) return false;
      reader_->read(row_, count, selected_, time_, values_);
    } catch (const std::runtime_error&) {
      if (ended) throw;
      // The worker was lost and another repairs the file: open it again with the next change.
      reader_.reset();
      return false;
    }
    response.mutable_time()->Add(time_.begin(), time_.end());
    response.mutable_values()->Add(values_.begin(), values_.end());
    row_ += static_cast<std::int64_t>(time_.size());
    return !time_.empty();
  }

  void add_columns(v1::StreamHistoryResponse& response) {
    for (const std::size_t index : selected_) response.add_columns(reader_->columns()[index]);
    columns_sent_ = true;
  }

  v1::Job read_job() {
    return store_.read([&](store::Database& database) { return store::get_job(database, job()); });
  }

  const v1::StreamHistoryRequest request_;
  store::Store& store_;
  const std::filesystem::path directory_;
  std::unique_ptr<results::HistoryReader> reader_;
  int attempt_ = 0;
  std::vector<std::size_t> selected_;
  std::vector<double> time_;
  std::vector<double> values_;
  std::int64_t row_;
  bool columns_sent_ = false;
};

}  // namespace

grpc::ServerWriteReactor<v1::StreamHistoryResponse>* stream_history(grpc::CallbackServerContext* context,
                                                                    const v1::StreamHistoryRequest& request,
                                                                    store::Store& store, Hub& hub,
                                                                    TaskQueue& queue,
                                                                    const std::filesystem::path& jobs_directory) {
  const std::int64_t job = store::job_number(request.job_id());
  if (request.first_row() < 0) {
    throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "FIRST_ROW", "first_row must not be negative");
  }
  return Stream<v1::StreamHistoryResponse>::start(std::make_shared<HistoryStream>(
      context, request, job, store, hub, queue, jobs_directory / std::to_string(job)));
}

}  // namespace trajan
