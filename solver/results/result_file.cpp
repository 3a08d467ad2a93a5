#include "solver/results/result_file.h"

#include <algorithm>
#include <stdexcept>

#include "solver/results/durable.h"
#include "solver/results/measures_table.h"
#include "solver/results/root.h"

namespace trajan::results {

std::unique_ptr<ResultFile> ResultFile::create(const std::filesystem::path& path, const Model& model,
                                               const Provenance& provenance) {
  std::unique_ptr<ResultFile> result(new ResultFile);
  result->file_ = open_file(path, Access::create);
  write_root(result->file_, model, provenance);
  create_measures(result->file_, model);
  result->histories_ = Histories::create(result->file_, model);
  result->warnings_ = WarningsTable::create(result->file_);
  if (model.outputs.samples_per_snapshot > 0) result->snapshots_ = Snapshots::create(result->file_, model);
  result->start_concurrent_reading();
  return result;
}

std::unique_ptr<ResultFile> ResultFile::repair(const std::filesystem::path& path, const Model& model,
                                               const Provenance& provenance, std::int64_t last_sample) {
  const hsize_t file_bytes = std::filesystem::file_size(path);
  std::unique_ptr<ResultFile> result(new ResultFile);
  result->file_ = open_file(path, Access::repair);
  // The superblock of a file that was not closed knows less than the file holds: without this, new
  // chunks would be put on top of old ones.
  check(H5Fincrement_filesize(result->file_, 0), "find the end of the file");
  if (run_identity(result->file_) != run_identity(provenance))
    throw std::runtime_error("cannot go on with the file: it belongs to another run");
  result->histories_ = Histories::open(result->file_, Dataset::Checksums::ignore);
  if (result->histories_->columns() != history_columns(model))
    throw std::runtime_error("cannot go on with the file: its columns are not the scene's");
  result->histories_->cut(static_cast<hsize_t>(last_sample + 1), file_bytes);
  result->warnings_ = WarningsTable::open(result->file_, Dataset::Checksums::ignore);
  if (const std::int64_t period = model.outputs.samples_per_snapshot; period > 0) {
    result->snapshots_ = Snapshots::open(result->file_, model);
    const auto due = static_cast<hsize_t>(last_sample / period + 1);
    result->snapshots_->cut(std::min(due, result->snapshots_->count()), file_bytes);
  }
  result->start_concurrent_reading();
  return result;
}

ResultFile::~ResultFile() {
  if (file_ >= 0) divert_to_memory(file_descriptor(file_));
}

void ResultFile::start_concurrent_reading() {
  check(H5Fflush(file_, H5F_SCOPE_LOCAL), "write the file");
  check(H5Fstart_swmr_write(file_), "let others read the file while it is written");
  make_durable();
}

void ResultFile::flush() { check(H5Fflush(file_, H5F_SCOPE_LOCAL), "write the file"); }

void ResultFile::make_durable() { synchronize(file_descriptor(file_)); }

void ResultFile::close() {
  flush();
  histories_.reset();
  warnings_.reset();
  snapshots_.reset();
  make_durable();
  file_.close("close the file");
}

}  // namespace trajan::results
