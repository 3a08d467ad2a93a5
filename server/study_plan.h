#pragma once

#include "server/store_studies.h"

namespace trajan {

/// What the study will run. Throws ServiceError INVALID_ARGUMENT for dials that are not allowed, fields that do
/// not exist, or scenes that have violations: all of them, each with the runs that it is of.
store::StudyPlan plan_study(const v1::SubmitStudyRequest& request);

/// Makes the changes of a setting; what cannot be changed is a violation.
google::protobuf::RepeatedPtrField<v1::Violation> change_scene(v1::Scene& scene, const v1::Setting& setting);

}  // namespace trajan
