#pragma once

#include <stdexcept>

#include "solver/recorder.h"

namespace trajan {

/// A run has gone bad.
class Diverged : public std::runtime_error {
 public:
  explicit Diverged(Divergence divergence)
      : std::runtime_error(divergence.cause), divergence_(std::move(divergence)) {}
  const Divergence& divergence() const { return divergence_; }

 private:
  Divergence divergence_;
};

}  // namespace trajan
