#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "solver/model/model.h"

namespace trajan {

/// All particles at one time, in the order of their numbers.
struct Snapshot {
  double time = 0;
  std::vector<double> position;  ///< (n, axes) row-major, axes as vector_components
  std::vector<double> velocity;  ///< (n, axes)
  /// As OutputPlan::snapshot_fields, each (n, width) row-major; not a number where there is no such field.
  std::vector<std::vector<double>> fields;
};

/// The whole state of a simulation at a sample, enough to go on with the same bits.
struct Checkpoint {
  std::int64_t sample = 0;  ///< the last sample that was recorded before it
  std::int64_t step = 0;
  double time = 0;
  struct Array {
    std::string name;
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::int32_t>> values;
  };
  std::vector<Array> arrays;
};

struct MeasureValue {
  std::string name;
  std::string quantity;
  double value = 0;
  std::optional<double> exact;
  std::optional<double> error;  ///< (value - exact) / |exact|, or value where exact is 0
  std::optional<double> tolerance;
  std::string source;
};

/// Why a run went bad. What was recorded before stays valid.
struct Divergence {
  std::int64_t step = 0;
  double time = 0;
  std::int64_t particle = -1;  ///< -1: not about one
  std::string cause;
  std::string remedy;
};

/// What makes the rest of a run's numbers doubtful though it goes on.
struct Warning {
  std::string name;  ///< of its kind and of what it is about, at most 100 bytes; a run says each once
  std::int64_t step = 0;
  double time = 0;
  std::int64_t particle = -1;
  Vector place;  ///< of the particle
  std::string cause;
  std::string remedy;
};

/// Warnings that are kept of a run, at most.
inline constexpr std::size_t most_warnings = 32;

/// Where a run's results go. Calls come from one thread, samples in order, a snapshot after the sample
/// of the same time. Implementations throw std::runtime_error when they cannot store.
class Recorder {
 public:
  virtual ~Recorder() = default;
  /// Row `row` of the histories (columns as history_columns(model)).
  virtual void sample(std::int64_t row, double time, std::span<const double> columns) = 0;
  virtual void snapshot(std::int64_t row, const Snapshot& snapshot) = 0;
  /// Everything before it must be durable when this returns.
  virtual void checkpoint(const Checkpoint& checkpoint) = 0;
  /// After the sample of the same time. Once for each name, and again for those from before in a run that goes on
  /// from a checkpoint.
  virtual void warn(const Warning&) {}
  /// Rows that are durable.
  virtual std::int64_t durable_rows() const = 0;
};

}  // namespace trajan
