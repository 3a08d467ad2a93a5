#pragma once

#include <string>
#include <vector>

#include "solver/accuracy/extrapolation.h"

/// Ladders of cell sizes over scenes of the gallery: is the true error within the band that a study claims without
/// knowing the exact value?
namespace trajan::verification {

struct BandCase {
  std::string scene;
  std::string measure;
  std::vector<accuracy::Level> levels;  ///< the coarsest first
  double exact = 0;                     ///< of the finest level
  bool is_answer = true;                ///< false: a check of rest or conservation
  accuracy::Estimate estimate;

  double error() const;
  bool is_covered() const { return estimate.band && error() <= *estimate.band; }
};

/// For every measure that has an exact value and does not hold to rounding: its ladders of 4, 2 and 1 times the
/// scene's cell size, of 2, 4/3 and 1 times, and, if `finer`, of 2, 1 and 1/2 times. Ladders with a level that is
/// not a valid scene or diverges are left out; so are finer ones of scenes with a constant "cell", whose exact
/// values are those at the places that particles have with the scene's own cells.
///
/// A ladder approaches the limit of small cells. Of checks whose exact value is 0 (an energy balance, a remaining
/// speed) that is not the exact value: time that is too short or steps that are too long remain. They are no
/// answers.
std::vector<BandCase> band_cases(const std::string& scene, bool finer);

}  // namespace trajan::verification
