#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trajan::results {

/// SHA-256 in hexadecimal.
std::string sha256(std::string_view text);
/// Throws std::runtime_error if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace trajan::results
