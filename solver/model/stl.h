#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/geometry.h"

namespace trajan {

using Triangle = std::array<Vector, 3>;

/// What is wrong with the content of an STL file.
class StlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The triangles of an STL file, ASCII or binary; the normals in it are ignored, as the order of corners
/// says the same. Throws StlError.
std::vector<Triangle> read_stl(std::string_view content);

}  // namespace trajan
