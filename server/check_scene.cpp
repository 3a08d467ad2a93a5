#include "server/check_scene.h"

#include "server/convert.h"
#include "server/errors.h"

namespace trajan {

google::protobuf::RepeatedPtrField<v1::Violation> violations_of(const v1::Scene& scene) {
  try {
    validate(to_scene(scene));
  } catch (const InvalidScene& invalid) {
    return to_proto(invalid.violations());
  }
  return {};
}

Model require_valid(const v1::Scene& scene) {
  try {
    return validate(to_scene(scene));
  } catch (const InvalidScene& invalid) {
    ServiceError error(grpc::StatusCode::INVALID_ARGUMENT, "INVALID_SCENE", invalid.what());
    *error.details().mutable_violations() = to_proto(invalid.violations());
    throw error;
  }
}

}  // namespace trajan
