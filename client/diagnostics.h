#pragma once

#include <string>
#include <string_view>

#include "client/scene_text.h"

namespace trajan::client {

/// `file:line:column: error: message`, the line of the scene, a caret under the mistake, and the hint, as
/// compilers print them. Ends with a newline.
std::string format_diagnostic(const Diagnostic& diagnostic, const SceneText& scene, std::string_view file,
                              bool colours);

}  // namespace trajan::client
