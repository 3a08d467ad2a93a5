#include "solver/model/validate.h"

namespace trajan {

InvalidScene::InvalidScene(std::vector<Violation> violations)
    : std::runtime_error("invalid scene: " + violations.at(0).path + ": " + violations.at(0).problem),
      violations_(std::move(violations)) {}

}  // namespace trajan
