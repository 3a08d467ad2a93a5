#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "solver/model/model.h"

namespace trajan {

/// One thing that is wrong with a scene.
struct Violation {
  std::string path;     ///< field path as in the schema, "bodies[0].geometry.disc.radius"
  std::string value;    ///< what was given, as text; empty if nothing was
  std::string problem;  ///< what is wrong
  std::string remedy;   ///< what would be right
};

/// Carries all violations of a scene, never none.
class InvalidScene : public std::runtime_error {
 public:
  explicit InvalidScene(std::vector<Violation> violations);
  const std::vector<Violation>& violations() const { return violations_; }

 private:
  std::vector<Violation> violations_;
};

/// Checks everything and translates. Takes time and memory that do not grow with the number of
/// particles beyond what loads and probes select. Throws InvalidScene with every violation there is.
Model validate(const Scene& scene);

}  // namespace trajan
