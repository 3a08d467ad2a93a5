#pragma once

#include <array>

namespace trajan {

/// Along x, y and z; axes that the grid lacks are 0.
using Components = std::array<double, 3>;

inline double dot(const Components& a, const Components& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace trajan
