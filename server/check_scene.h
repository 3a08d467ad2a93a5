#pragma once

#include <vector>

#include "solver/model/model.h"
#include "trajan/v1/jobs.pb.h"
#include "trajan/v1/scene.pb.h"

namespace trajan {

/// What is wrong with a scene; empty if nothing is.
google::protobuf::RepeatedPtrField<v1::Violation> violations_of(const v1::Scene& scene);

/// Throws ServiceError INVALID_ARGUMENT with all violations as details.
Model require_valid(const v1::Scene& scene);

}  // namespace trajan
