#pragma once

#include <string>
#include <vector>

/// Contact between bodies, as scenes ask for it.
namespace trajan {

/// `bodies` empty: all.
struct BodyContact {
  std::vector<std::string> bodies;
  double friction = 0;
};

}  // namespace trajan
