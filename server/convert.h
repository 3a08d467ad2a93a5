#pragma once

#include "solver/analyses/run.h"
#include "solver/model/validate.h"
#include "solver/recorder.h"
#include "solver/scene/scene.h"
#include "trajan/v1/jobs.pb.h"
#include "trajan/v1/scene.pb.h"

/// Between the messages of the API and the solver's own types, in both directions. Nothing here checks
/// or decides anything: every message has a translation, and `validate` judges the result.
namespace trajan {

/// Field for field. A field that is left out takes the default of solver/scene/scene.h, an unknown enum
/// value becomes `unspecified` (a measure with an unknown kind of extreme: one without a kind), and the
/// fields of a material's law become its parameters by name. Throws nothing but std::bad_alloc.
Scene to_scene(const v1::Scene& message);

v1::Violation to_proto(const Violation& violation);
google::protobuf::RepeatedPtrField<v1::Violation> to_proto(const std::vector<Violation>& violations);
v1::MeasureValue to_proto(const MeasureValue& value);

/// Without `remaining`, which the solver does not know.
v1::Progress to_proto(const RunProgress& progress);

/// A failure with the reason "DIVERGED".
v1::Failure to_proto(const Divergence& divergence);

v1::Warning to_proto(const Warning& warning);

/// Without `result_bytes`, which the solver does not know.
v1::Plan to_proto(const ModelPlan& plan);

}  // namespace trajan
