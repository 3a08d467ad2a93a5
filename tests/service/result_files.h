#pragma once

#include <filesystem>
#include <string>

namespace trajan::test {

/// What differs between the datasets of two files: names, extents or any bit of their numbers. Empty if
/// nothing does. The rows of tables with texts are not compared.
std::string compare_datasets(const std::filesystem::path& left, const std::filesystem::path& right);

}  // namespace trajan::test
