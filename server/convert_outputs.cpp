#include "server/convert_parts.h"

namespace trajan {
namespace {

Field to_field(int value) {
  switch (value) {
    case v1::POSITION:
      return Field::position;
    case v1::DISPLACEMENT:
      return Field::displacement;
    case v1::VELOCITY:
      return Field::velocity;
    case v1::STRESS:
      return Field::stress;
    case v1::STRAIN:
      return Field::strain;
    case v1::DEFORMATION_GRADIENT:
      return Field::deformation_gradient;
    case v1::PRESSURE:
      return Field::pressure;
    case v1::VON_MISES_STRESS:
      return Field::von_mises_stress;
    default:
      return Field::unspecified;
  }
}

ProbeDefinition to_probe(const v1::Probe& message) {
  ProbeDefinition probe;
  probe.name = message.name();
  switch (message.where_case()) {
    case v1::Probe::kNearest:
      probe.where = to_vector(message.nearest());
      break;
    case v1::Probe::kMean:
      probe.where = to_region(message.mean());
      break;
    case v1::Probe::kLargest:
      probe.where = to_region(message.largest());
      probe.statistic = Statistic::largest;
      break;
    case v1::Probe::kSmallest:
      probe.where = to_region(message.smallest());
      probe.statistic = Statistic::smallest;
      break;
    case v1::Probe::WHERE_NOT_SET:
      break;
  }
  probe.fields = convert_all(message.fields(), to_field);
  probe.body = message.body();
  probe.history = {message.history().begin(), message.history().end()};
  return probe;
}

using MeasureKind = decltype(MeasureDefinition::kind);

/// An unknown kind is no kind: another extreme than the one that was meant would be a wrong answer.
MeasureKind to_extreme(const v1::Extreme& message) {
  switch (message.kind()) {
    case v1::Extreme::MAGNITUDE:
      return ExtremeValue{ExtremeKind::magnitude};
    case v1::Extreme::MAXIMUM:
      return ExtremeValue{ExtremeKind::maximum};
    case v1::Extreme::MINIMUM:
      return ExtremeValue{ExtremeKind::minimum};
    default:
      return {};
  }
}

DominantFrequency to_dominant_frequency(const v1::DominantFrequency& message) {
  DominantFrequency frequency;
  frequency.lowest = message.lowest();
  if (message.has_highest()) frequency.highest = message.highest();
  return frequency;
}

Deviation to_deviation(const v1::Deviation& message) {
  Deviation deviation;
  deviation.exact_history = message.exact_history();
  if (message.has_scale()) deviation.scale = message.scale();
  return deviation;
}

MeasureKind to_measure_kind(const v1::Measure& message) {
  switch (message.kind_case()) {
    case v1::Measure::kFinal:
      return FinalValue{};
    case v1::Measure::kExtreme:
      return to_extreme(message.extreme());
    case v1::Measure::kMean:
      return MeanValue{};
    case v1::Measure::kDominantFrequency:
      return to_dominant_frequency(message.dominant_frequency());
    case v1::Measure::kDeviation:
      return to_deviation(message.deviation());
    case v1::Measure::KIND_NOT_SET:
      break;
  }
  return {};
}

}  // namespace

Outputs to_outputs(const v1::Outputs& message) {
  Outputs outputs;
  if (message.has_samples()) outputs.samples = message.samples();
  if (message.has_snapshots()) outputs.snapshots = message.snapshots();
  if (!message.snapshot_fields().empty()) {
    outputs.snapshot_fields = convert_all(message.snapshot_fields(), to_field);
  }
  outputs.probes = convert_all(message.probes(), to_probe);
  outputs.snapshot_history = {message.snapshot_history().begin(), message.snapshot_history().end()};
  outputs.reactions = {message.reactions().begin(), message.reactions().end()};
  return outputs;
}

MeasureDefinition to_measure(const v1::Measure& message) {
  MeasureDefinition measure;
  measure.name = message.name();
  measure.quantity = message.quantity();
  measure.kind = to_measure_kind(message);
  measure.from = message.from();
  if (message.has_until()) measure.until = message.until();
  measure.exact = message.exact();
  measure.source = message.source();
  if (message.has_tolerance()) measure.tolerance = message.tolerance();
  return measure;
}

}  // namespace trajan
