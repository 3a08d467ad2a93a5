#include "tests/stability/all_cases.h"

namespace trajan::stability {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"time_steps", time_steps}, {"poissons_ratios", poissons_ratios},
      {"contrasts", contrasts},   {"deformations", deformations_and_motions},
      {"long_runs", long_runs},   {"impacts", impacts},
      {"scales", scales},         {"tiny", tiny},
      {"statics", statics},       {"floats", floats},
  };
  return all;
}

}  // namespace trajan::stability
