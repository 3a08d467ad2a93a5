#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/scene/geometry.h"

/// What is recorded and measured, as scenes ask for it.
namespace trajan {

enum class Field {
  unspecified,
  position,
  displacement,
  velocity,
  stress,
  strain,
  deformation_gradient,
  pressure,
  von_mises_stress,
  history  ///< what laws remember; scenes name it
};

/// What a probe tells of the particles in a region.
enum class Statistic { mean, largest, smallest };

/// `where`: Vector for the nearest particle, a region for a statistic of the particles in it.
struct ProbeDefinition {
  std::string name;
  std::variant<std::monostate, Vector, Region> where;
  std::vector<Field> fields;
  std::string body;
  std::vector<std::string> history = {};
  Statistic statistic = Statistic::mean;
};

/// `snapshots` empty: 10 or the nearest smaller divisor of `samples`.
struct Outputs {
  std::int32_t samples = 200;
  std::optional<std::int32_t> snapshots;
  std::vector<Field> snapshot_fields = {Field::displacement, Field::stress};
  std::vector<ProbeDefinition> probes;
  std::vector<std::string> snapshot_history;
  std::vector<std::string> reactions = {};
};

struct FinalValue {};
enum class ExtremeKind { magnitude, maximum, minimum };
struct ExtremeValue {
  ExtremeKind kind = ExtremeKind::magnitude;
};
struct MeanValue {};
struct DominantFrequency {
  double lowest = 0;
  std::optional<double> highest;
};
struct Deviation {
  std::string exact_history;
  double scale = 1;
};

struct MeasureDefinition {
  std::string name;
  std::string quantity;
  std::variant<std::monostate, FinalValue, ExtremeValue, MeanValue, DominantFrequency, Deviation> kind;
  double from = 0;
  std::optional<double> until;
  std::string exact;
  std::string source;
  std::optional<double> tolerance;
};

}  // namespace trajan
