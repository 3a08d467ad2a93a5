#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "solver/results/histories.h"
#include "solver/results/results.h"
#include "solver/results/snapshots.h"
#include "solver/results/warnings_table.h"

namespace trajan::results {

/// A result file that is open for writing, in single-writer-multiple-reader mode: readers in other
/// processes see it grow. Whatever is flushed survives the end of the process; whatever `make_durable`
/// has returned from survives the end of the machine.
class ResultFile {
 public:
  /// Every object is made here; later there are only new rows and values.
  static std::unique_ptr<ResultFile> create(const std::filesystem::path& path, const Model& model,
                                            const Provenance& provenance);
  /// Opens a file whose writer may have been killed at any moment, and cuts it back to what was recorded
  /// up to sample `last_sample`. Throws std::runtime_error if that is not in it.
  static std::unique_ptr<ResultFile> repair(const std::filesystem::path& path, const Model& model,
                                            const Provenance& provenance, std::int64_t last_sample);
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;
  /// Leaves the file as it is on disk, as a kill would.
  ~ResultFile();

  hid_t id() const { return file_; }
  Histories& histories() { return *histories_; }
  WarningsTable& warnings() { return *warnings_; }
  /// Only if the scene wants any.
  Snapshots& snapshots() { return *snapshots_; }
  void flush();
  void make_durable();
  void close();

 private:
  ResultFile() = default;
  void start_concurrent_reading();

  Handle file_;
  std::optional<Histories> histories_;
  std::optional<WarningsTable> warnings_;
  std::optional<Snapshots> snapshots_;
};

}  // namespace trajan::results
