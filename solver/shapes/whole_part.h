#pragma once

#include <type_traits>

#include "solver/executors/instruction_set.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Of a number that is not negative. It stays a double: to an integer and back takes two instructions more.
constexpr double whole_part(double number) {
  return std::is_constant_evaluated() ? static_cast<int>(number) : __builtin_trunc(number);
}
constexpr double half(double number) { return 0.5 * number; }
constexpr double twice(double number) { return 2 * number; }

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
