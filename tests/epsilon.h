#pragma once

#include <limits>

namespace trajan::test {

/// Rounding of one operation, relative to its result.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace trajan::test
