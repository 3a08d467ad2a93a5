#pragma once

#include <span>
#include <vector>

#include "solver/model/model.h"
#include "solver/recorder.h"
#include "solver/results/handles.h"

/// /measures: one row per measure of the scene with name, quantity, value, exact, error, tolerance and
/// source. Numbers that do not exist are NaN.
namespace trajan::results {

/// Before the file goes to single-writer-multiple-reader mode: all that is known without values.
void create_measures(hid_t file, const Model& model);
/// Fills in the numbers of the rows whose names are those of `measures`.
void write_measures(hid_t file, std::span<const MeasureValue> measures);
/// Those that have a value.
std::vector<MeasureValue> read_measures(hid_t file);

}  // namespace trajan::results
