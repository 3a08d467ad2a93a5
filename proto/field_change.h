#pragma once

#include <stdexcept>
#include <string>

#include "trajan/v1/scene.pb.h"

namespace trajan {

/// Why a field cannot be changed; `what()` says what is wrong.
class FieldChangeError : public std::runtime_error {
 public:
  FieldChangeError(const std::string& problem, std::string advice)
      : std::runtime_error(problem), hint(std::move(advice)) {}
  std::string hint;  ///< what would be right; may be empty
};

/// Changes one field of a scene as people say it: `PATH=VALUE`, in UTF-8. A path names fields, and elements of
/// lists by number or by name: `domain.cell_size`, `bodies[0].material`, `constants[L].value`. The value is
/// written as in a scene file, a text also without its quotes; messages are `{…}` and whole lists `[…]`. What was
/// there is replaced. Returns the path with all elements by number, as violations have it. Throws
/// FieldChangeError.
std::string change_field(v1::Scene& scene, const std::string& change);

}  // namespace trajan
