#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/recorder.h"
#include "solver/results/history_block.h"

/// Result files and checkpoints: the only code that sees HDF5. A job's directory holds
///   result.vtkhdf.part   while it is written (single writer, many readers)
///   result.vtkhdf        complete, with its digest known
///   result.xmf2          for ParaView 5.11
///   checkpoint.h5        the last checkpoint
namespace trajan::results {

inline constexpr const char* result_name = "result.vtkhdf";
inline constexpr const char* partial_name = "result.vtkhdf.part";
inline constexpr const char* checkpoint_name = "checkpoint.h5";
inline constexpr const char* xdmf_name = "result.xmf2";

/// What the root attributes say beside the model.
struct Provenance {
  std::string scene_text;  ///< as submitted, protobuf text format
  std::string solver_version;
};

enum class Status { running, succeeded, diverged, cancelled };

struct FinishedFile {
  std::filesystem::path path;
  std::int64_t size = 0;
  std::string sha256;     ///< hexadecimal
  bool complete = false;  ///< the run went to its end
};

/// A run whose result file is complete, as found in its directory.
struct FinishedRun {
  FinishedFile file;
  Status status = Status::running;
  std::vector<MeasureValue> measures;
  std::optional<Divergence> divergence;
  std::vector<Warning> warnings;
};

/// Set if the directory already holds the complete result of this run (a worker was killed between
/// finishing the file and saying so): report it instead of opening a writer, which starts anew.
std::optional<FinishedRun> finished_run(const std::filesystem::path& directory, const Provenance& provenance);

/// Writes one job's result file. Frames are durable (fsync) before `durable_rows` counts them; any kill
/// loses at most what was not counted. One thread.
class ResultWriter : public Recorder {
 public:
  /// Starts anew, or, if `directory` holds a checkpoint and a partial file, repairs the file, cuts it
  /// back to the checkpoint and hands the checkpoint out by `resume_point`. Samples are committed together
  /// every `commit_interval` of wall time: each commit waits for the disk. Throws std::runtime_error, also
  /// if another process writes to the directory.
  static std::unique_ptr<ResultWriter> open(
      const std::filesystem::path& directory, const Model& model, const Provenance& provenance,
      std::chrono::milliseconds commit_interval = std::chrono::milliseconds(200));
  /// Moved out once; empty for a new run.
  virtual std::optional<Checkpoint> resume_point() = 0;
  /// All histories recorded so far, also those before a resume: times and row-major values.
  virtual void histories(std::vector<double>& time, std::vector<double>& values) = 0;
  /// All that were given, also those from before a resume; not after `finish` or `suspend`.
  virtual const std::vector<Warning>& warnings() const = 0;
  /// Closes, computes the digest, makes durable and renames. Removes the checkpoint. After this the
  /// writer must only be destroyed.
  virtual FinishedFile finish(Status status, std::span<const MeasureValue> measures,
                              const std::optional<Divergence>& divergence) = 0;
  /// Makes everything durable and closes, to be resumed later from the last checkpoint.
  virtual void suspend() = 0;
};

/// Reads histories of a complete file, or of one that is being written by another process.
class HistoryReader {
 public:
  /// Opens result.vtkhdf or, if it is not there, the partial file. Throws std::runtime_error if there is
  /// neither or it cannot be read (yet).
  static std::unique_ptr<HistoryReader> open(const std::filesystem::path& directory);
  virtual ~HistoryReader() = default;
  virtual const std::vector<std::string>& columns() const = 0;
  /// Committed rows; asks the file again.
  virtual std::int64_t rows() = 0;
  /// Rows that the file keeps together: chunks begin at its multiples.
  virtual std::int64_t chunk_rows() const = 0;
  /// `count` rows from `first` on, clipped to rows(), of the selected columns, in the selection's order. Keeps a
  /// chunk of each dataset that they lie in, so that reading on costs little: 32 KiB at most for each column.
  virtual void read(std::int64_t first, std::int64_t count, std::span<const std::size_t> selected,
                    HistoryBlock& block) = 0;
};

/// Writes `result.xmf2` beside a finished file. Returns its path.
std::filesystem::path write_xdmf(const std::filesystem::path& result_file);

}  // namespace trajan::results
