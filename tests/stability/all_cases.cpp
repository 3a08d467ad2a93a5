#include "tests/stability/all_cases.h"

namespace trajan::stability {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"time_steps", time_steps}, {"contrasts", contrasts}, {"long_runs", long_runs},
      {"scales", scales},         {"tiny", tiny},           {"floats", floats},
  };
  return all;
}

}  // namespace trajan::stability
