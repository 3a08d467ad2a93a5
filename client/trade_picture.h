#pragma once

#include <filesystem>

#include "trajan/v1/studies.pb.h"

namespace trajan::client {

/// Draws the error of a tradeoff's runs over what they took, in logarithmic axes: a line for each method, its
/// points in the order of the cell sizes, and Pareto's set as a grey band behind them. Throws CommandError if
/// there is nothing to draw, or gnuplot is missing.
void draw_trade(const v1::Study& study, const std::filesystem::path& picture);

}  // namespace trajan::client
