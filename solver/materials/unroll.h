#pragma once

#include <type_traits>
#include <utility>

#include "solver/executors/instruction_set.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// body(0), body(1), ..., body(Count - 1), each index a constant. Loops over particles are vectorised only if
/// nothing inside is a loop, and small arrays are registers only if all their indices are constants.
template <int Count, class Body>
[[gnu::always_inline]] constexpr void unroll(Body&& body) {
  [&]<int... index>(std::integer_sequence<int, index...>) __attribute__((always_inline)) {
    (body(std::integral_constant<int, index>{}), ...);
  }
  (std::make_integer_sequence<int, Count>{});
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
