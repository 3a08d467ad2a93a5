#pragma once

#include "solver/schemes/kernels.h"
#include "tests/bench/scenes.h"

namespace trajan {
namespace x86_64_v3 {
/// The kernels that tests/levels compiles.
extern const Kernels compiled_kernels;

/// Whether they can take such steps.
inline bool can_step(const bench::Choice& choice) {
  const bool known = choice.precision == "DOUBLE" || choice.shape_functions == "linear" ||
                     choice.shape_functions == "quadratic_bspline";
  return choice.kind == bench::Kind::explicit_steps && known;
}
}  // namespace x86_64_v3
}  // namespace trajan
