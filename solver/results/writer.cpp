#include <algorithm>
#include <cassert>
#include <chrono>
#include <stdexcept>

#include "solver/results/checkpoint.h"
#include "solver/results/digest.h"
#include "solver/results/durable.h"
#include "solver/results/measures_table.h"
#include "solver/results/result_file.h"
#include "solver/results/results.h"
#include "solver/results/root.h"

namespace trajan::results {

namespace {

using Clock = std::chrono::steady_clock;

/// Values that are gathered before they are committed, however short the time.
constexpr std::size_t largest_batch = 1 << 18;

class Writer : public ResultWriter {
 public:
  Writer(const std::filesystem::path& directory, const Model& model, const Provenance& provenance,
         std::chrono::milliseconds commit_interval)
      : lock_(directory),
        directory_(directory),
        identity_(run_identity(provenance)),
        samples_per_snapshot_(model.outputs.samples_per_snapshot),
        commit_interval_(commit_interval) {
    resume(model, provenance);
    if (!file_) start_anew(model, provenance);
    synchronize(directory_);
    columns_ = file_->histories().columns().size();
    durable_rows_ = static_cast<std::int64_t>(file_->histories().rows());
  }

  std::optional<Checkpoint> resume_point() override { return std::exchange(resume_point_, std::nullopt); }

  void sample([[maybe_unused]] std::int64_t row, double time, std::span<const double> columns) override {
    assert(row == durable_rows_ + static_cast<std::int64_t>(times_.size()));
    assert(columns.size() == columns_);
    times_.push_back(time);
    values_.insert(values_.end(), columns.begin(), columns.end());
    if (values_.size() >= largest_batch || Clock::now() - last_commit_ >= commit_interval_)
      guarded([&] { commit(); });
  }

  void snapshot(std::int64_t row, const Snapshot& snapshot) override {
    guarded([&] {
      commit();
      const auto index = static_cast<hsize_t>(row / samples_per_snapshot_);
      assert(index <= file_->snapshots().count());
      file_->snapshots().write_arrays(index, snapshot);
      file_->flush();
      file_->snapshots().write_time(index, snapshot.time);
      file_->flush();
      file_->snapshots().write_count(index + 1);
      file_->flush();
      file_->make_durable();
    });
  }

  void checkpoint(const Checkpoint& checkpoint) override {
    assert(checkpoint.sample < durable_rows_ + static_cast<std::int64_t>(times_.size()));
    guarded([&] { commit(); });
    write_checkpoint(directory_ / checkpoint_name, identity_, checkpoint);
  }

  void warn(const Warning& warning) override {
    guarded([&] {
      commit();
      if (!file_->warnings().add(warning)) return;
      file_->flush();
      file_->make_durable();
    });
  }

  std::int64_t durable_rows() const override { return durable_rows_; }

  void histories(std::vector<double>& time, std::vector<double>& values) override {
    guarded([&] {
      commit();
      std::vector<std::size_t> all(columns_);
      for (std::size_t c = 0; c < columns_; ++c) all[c] = c;
      const auto rows = static_cast<hsize_t>(durable_rows_), step = file_->histories().chunk_rows();
      time.clear();
      values.resize(rows * columns_);
      HistoryBlock block;
      for (hsize_t row = 0; row < rows; row += step) {
        file_->histories().read(row, std::min(step, rows - row), all, block);
        time.insert(time.end(), block.time.begin(), block.time.end());
        block.copy_rows(0, block.rows(), values.data() + row * columns_);
      }
    });
  }

  FinishedFile finish(Status status, std::span<const MeasureValue> measures,
                      const std::optional<Divergence>& divergence) override {
    const std::filesystem::path partial = directory_ / partial_name, path = directory_ / result_name;
    FinishedFile finished;
    guarded([&] {
      commit();
      write_measures(file_->id(), measures);
      write_end(file_->id(), status, divergence);
      file_->close();
      finished = {path, static_cast<std::int64_t>(std::filesystem::file_size(partial)), sha256_of_file(partial),
                  status == Status::succeeded};
      publish(partial, path);
      std::filesystem::remove(directory_ / checkpoint_name);
    });
    file_.reset();
    return finished;
  }

  const std::vector<Warning>& warnings() const override { return file_->warnings().warnings(); }

  void suspend() override {
    guarded([&] {
      commit();
      file_->close();
    });
    file_.reset();
  }

 private:
  /// Leaves `file_` empty if there is nothing to go on with.
  void resume(const Model& model, const Provenance& provenance) {
    std::optional<Checkpoint> checkpoint = read_checkpoint(directory_ / checkpoint_name, identity_);
    if (!checkpoint || !std::filesystem::exists(directory_ / partial_name)) return;
    try {
      file_ = ResultFile::repair(directory_ / partial_name, model, provenance, checkpoint->sample);
      resume_point_ = std::move(checkpoint);
    } catch (const std::runtime_error&) {
      // Beyond repair. The results are the same when computed again.
    }
  }

  void start_anew(const Model& model, const Provenance& provenance) {
    for (const char* name : {checkpoint_name, partial_name, result_name, xdmf_name})
      std::filesystem::remove(directory_ / name);
    guarded([&] { file_ = ResultFile::create(directory_ / partial_name, model, provenance); });
  }

  /// Values first, then their times: a row is there when its time is. Counted when on the disk.
  void commit() {
    if (times_.empty()) return;
    const auto first = static_cast<hsize_t>(durable_rows_);
    file_->histories().write_values(first, values_);
    file_->flush();
    file_->histories().write_times(first, times_);
    file_->flush();
    file_->make_durable();
    durable_rows_ += static_cast<std::int64_t>(times_.size());
    times_.clear();
    values_.clear();
    last_commit_ = Clock::now();
  }

  /// Names the file in errors. After one, nothing more reaches the file.
  template <typename Action>
  void guarded(const Action& action) {
    silence_hdf5();
    try {
      action();
    } catch (const std::runtime_error& error) {
      file_.reset();
      throw std::runtime_error((directory_ / partial_name).string() + ": " + error.what());
    }
  }

  DirectoryLock lock_;
  std::filesystem::path directory_;
  std::string identity_;
  std::int64_t samples_per_snapshot_;
  std::chrono::milliseconds commit_interval_;
  std::unique_ptr<ResultFile> file_;
  std::optional<Checkpoint> resume_point_;
  std::size_t columns_ = 0;
  std::int64_t durable_rows_ = 0;
  std::vector<double> times_;   ///< of the samples that are not committed yet
  std::vector<double> values_;  ///< (times_.size(), columns_)
  Clock::time_point last_commit_ = Clock::now();
};

}  // namespace

std::unique_ptr<ResultWriter> ResultWriter::open(const std::filesystem::path& directory, const Model& model,
                                                 const Provenance& provenance,
                                                 std::chrono::milliseconds commit_interval) {
  silence_hdf5();
  return std::make_unique<Writer>(directory, model, provenance, commit_interval);
}

std::optional<FinishedRun> finished_run(const std::filesystem::path& directory, const Provenance& provenance) {
  silence_hdf5();
  const std::filesystem::path path = directory / result_name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    FinishedRun run;
    {
      const Handle file = open_file(path, Access::read_closed);
      if (run_identity(file) != run_identity(provenance)) return std::nullopt;
      run.status = read_status(file);
      run.measures = read_measures(file);
      run.divergence = read_divergence(file);
      run.warnings = WarningsTable::open(file, Dataset::Checksums::verify).warnings();
    }
    run.file = {path, static_cast<std::int64_t>(std::filesystem::file_size(path)), sha256_of_file(path),
                run.status == Status::succeeded};
    return run;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

}  // namespace trajan::results
