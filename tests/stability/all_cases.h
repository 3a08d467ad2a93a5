#pragma once

#include "tests/stability/extremes.h"

/// One function in each file of this folder.
namespace trajan::stability {

std::vector<Extreme> contrasts(Size size);
std::vector<Extreme> deformations_and_motions(Size size);
std::vector<Extreme> floats(Size size);
std::vector<Extreme> impacts(Size size);
std::vector<Extreme> long_runs(Size size);
std::vector<Extreme> poissons_ratios(Size size);
std::vector<Extreme> scales(Size size);
std::vector<Extreme> statics(Size size);
std::vector<Extreme> time_steps(Size size);
std::vector<Extreme> tiny(Size size);

}  // namespace trajan::stability
