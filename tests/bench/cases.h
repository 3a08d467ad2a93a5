#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/bench/scenes.h"

namespace trajan::bench {

struct Case {
  Choice choice;
  Scene (*make)(const Choice&, double particles);
};

/// Everything that is measured, one case of each kind.
const std::vector<Case>& cases();

}  // namespace trajan::bench
