#pragma once

#include <span>
#include <string_view>

namespace trajan::client {

/// A scene that comes with the program.
struct GalleryScene {
  std::string_view name;
  std::string_view text;  ///< protobuf text format
};

/// In the order of their names.
std::span<const GalleryScene> gallery();

}  // namespace trajan::client
