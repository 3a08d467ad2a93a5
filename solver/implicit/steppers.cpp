#include "solver/implicit/steppers.h"

#include "solver/implicit/arc_length_steps.h"
#include "solver/implicit/dynamic_steps.h"
#include "solver/implicit/quasi_static_steps.h"
#include "solver/modal/mode_steps.h"
#include "solver/relaxation/dynamic_relaxation.h"

namespace trajan {

std::unique_ptr<Stepper> make_stepper(const Model& model, Executor& executor, const Checkpoint* resume) {
  const auto* statics = std::get_if<QuasiStatic>(&model.analysis);
  if (statics && statics->arc_length) return std::make_unique<ArcLengthSteps>(model, *statics, executor, resume);
  if (statics) return std::make_unique<QuasiStaticSteps>(model, *statics, executor, resume);
  if (const auto* analysis = std::get_if<ImplicitDynamics>(&model.analysis))
    return std::make_unique<DynamicSteps>(model, *analysis, executor, resume);
  if (const auto* analysis = std::get_if<Relaxation>(&model.analysis))
    return std::make_unique<DynamicRelaxation>(model, *analysis, executor, resume);
  if (const auto* analysis = std::get_if<Modal>(&model.analysis))
    return std::make_unique<ModalSteps>(model, *analysis, executor, resume);
  if (std::holds_alternative<Buckling>(model.analysis))
    return std::make_unique<BucklingSteps>(model, executor, resume);
  return nullptr;
}

}  // namespace trajan
