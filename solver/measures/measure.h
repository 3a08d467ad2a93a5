#pragma once

#include <span>
#include <vector>

#include "solver/model/model.h"
#include "solver/recorder.h"

namespace trajan {

/// Evaluates the model's measures over its complete histories.
/// `time`: (rows); `values`: (rows, history_columns(model).size()) row-major.
std::vector<MeasureValue> evaluate(const Model& model, std::span<const double> time,
                                   std::span<const double> values);

}  // namespace trajan
