#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/model/expression.h"
#include "solver/model/fields.h"
#include "solver/scene/outputs.h"

/// What a validated scene records and measures.
namespace trajan {

/// Follows one particle, or of several the mean weighted by volume, or each component's extreme value.
struct Probe {
  std::string name;
  std::vector<std::int64_t> particles;  ///< numbers, ascending; one for a nearest-particle probe
  Statistic statistic = Statistic::mean;
  std::vector<RecordedField> fields;
};

/// The histories' clock: sample i is at i * end_time / samples; a snapshot at every
/// `samples_per_snapshot`-th sample (0: none).
struct OutputPlan {
  std::int64_t samples = 0;
  std::int64_t samples_per_snapshot = 0;
  std::vector<RecordedField> snapshot_fields;  ///< beside positions and velocities
  std::vector<Probe> probes;
  std::vector<std::size_t> reactions;       ///< indices of boundary conditions
  std::vector<std::size_t> contact_forces;  ///< indices of bodies, each alone in its field
};

struct Measure {
  std::string name;
  std::string quantity;
  std::size_t column = 0;  ///< index into history_columns(model)
  std::variant<FinalValue, ExtremeValue, MeanValue, DominantFrequency, Deviation> kind;
  std::optional<Expression> exact_history;  ///< of t, for Deviation
  double from = 0;
  double until = 0;
  std::optional<double> exact;
  std::optional<double> tolerance;
  std::string source;
};

}  // namespace trajan
