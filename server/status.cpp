#include "server/status.h"

#include "server/errors.h"
#include "server/log.h"

namespace trajan {

grpc::Status to_status(grpc::CallbackServerContext& context, const std::exception_ptr& error) {
  if (!error) return grpc::Status::OK;
  try {
    std::rethrow_exception(error);
  } catch (const ServiceError& refused) {
    context.AddTrailingMetadata("trajan-error-bin", refused.details().SerializeAsString());
    return {refused.code(), refused.what()};
  } catch (const std::exception& defect) {
    logging::error("internal error", {{"error", defect.what()}});
    return {grpc::StatusCode::INTERNAL, defect.what()};
  }
}

}  // namespace trajan
