#pragma once

#include <string>

#include "trajan/v1/scene.pb.h"

namespace trajan::client {

/// Changes one field of a scene as the command line says it: `PATH=VALUE`. A path names fields, and elements of
/// lists by number or by name: `domain.cell_size`, `bodies[0].material`, `constants[L].value`. The value is
/// written as in a scene file, a text also without its quotes; messages are `{…}` and whole lists `[…]`. What was
/// there is replaced. Returns the path with all elements by number, as violations have it. Throws CommandError
/// (usage).
std::string change_field(v1::Scene& scene, const std::string& change);

}  // namespace trajan::client
