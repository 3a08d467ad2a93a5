#pragma once

#include "solver/implicit/implicit_steps.h"

namespace trajan {

/// Load steps of a quasi-static analysis.
class QuasiStaticSteps : public ImplicitSteps {
 public:
  QuasiStaticSteps(const Model& model, const QuasiStatic& analysis, Executor& executor, const Checkpoint* resume)
      : ImplicitSteps(model, executor, analysis.newton, analysis.load_steps, resume) {}
};

}  // namespace trajan
