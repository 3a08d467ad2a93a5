#pragma once

#include "trajan/v1/jobs.pb.h"

namespace trajan {

/// Gives the request's scene the settings that its preset or its explicit settings mean. Throws ServiceError
/// INVALID_ARGUMENT for settings without sense.
void resolve_fidelity(v1::SubmitJobRequest& request);

}  // namespace trajan
