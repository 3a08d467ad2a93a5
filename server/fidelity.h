#pragma once

#include "trajan/v1/fidelity.pb.h"
#include "trajan/v1/scene.pb.h"

namespace trajan {

/// Gives a scene the settings that a preset or explicit settings mean; a target leaves it as it is. Throws
/// ServiceError INVALID_ARGUMENT for settings without sense.
void resolve_fidelity(const v1::Fidelity& fidelity, v1::Scene& scene);

}  // namespace trajan
