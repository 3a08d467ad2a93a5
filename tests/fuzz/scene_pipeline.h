#pragma once

#include <string>

namespace trajan::testing {

enum class SceneFate { unreadable, invalid, valid };

/// Takes a scene's text through parse, convert, validate and plan, as the client and the server do, and
/// checks what they promise of every text: what cannot be read has a diagnostic, in the text, and what can
/// has none; an invalid scene has at least one violation; each violation names a field of the scene, says
/// what is wrong and what would be right, can be sent and is shown; a valid scene has a plan of finite
/// numbers. Throws std::logic_error for a broken promise.
SceneFate run_pipeline(const std::string& text);

}  // namespace trajan::testing
