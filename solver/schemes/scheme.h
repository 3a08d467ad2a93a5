#pragma once

#include <span>
#include <string_view>

namespace trajan {

/// The registered names, generated from the lists in schemes/CMakeLists.txt and shapes/CMakeLists.txt.
std::span<const std::string_view> scheme_names();
std::span<const std::string_view> shape_names();

/// Whether the scheme of this name keeps its shape functions with the reference positions; false for names that
/// are not registered.
bool is_total_lagrangian(std::string_view scheme);

}  // namespace trajan
