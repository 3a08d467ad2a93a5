#pragma once

#include <span>
#include <vector>

#include "solver/model/model.h"
#include "solver/recorder.h"

namespace trajan {

/// Evaluates the model's measures over its complete histories, all of whose values are finite.
/// `time`: (samples + 1); `values`: (samples + 1, history_columns(model).size()) row-major.
/// A deviation from a history whose formula is not defined at some sample is infinite.
std::vector<MeasureValue> evaluate(const Model& model, std::span<const double> time,
                                   std::span<const double> values);

}  // namespace trajan
