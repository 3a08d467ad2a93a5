#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace trajan {

/// Where an unknown lies: the index of its node along each axis of the grid, and which component of the
/// displacement it is.
struct Place {
  std::array<std::int32_t, 3> node{};
  std::int32_t component = 0;
  bool operator==(const Place&) const = default;
};

/// One for each row of a matrix, those of a node one after the other.
using Places = std::vector<Place>;

}  // namespace trajan
