#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/scene.h"

namespace trajan {

/// "did you mean "x"?" for the candidate nearest to `name` by edit distance, empty if none is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

/// The candidates, those first that contain `name`, the rest by edit distance from it.
std::vector<std::string> nearest_first(std::string_view name, std::span<const std::string> candidates);

/// `text` cut to a length that fits a message, between two characters of UTF-8.
std::string shortened(std::string_view text);

/// The same in quotes, for names in messages.
std::string quoted(std::string_view text);

/// "bodies" for "body", "schemes" for "scheme".
std::string plural(const std::string& noun);

/// The shortest decimal number that reads back as `value`.
std::string number_text(double value);

/// "(1, 2.5)"; the first `axes` components.
std::string point_text(Vector point, int axes);

/// "a, b, c", for messages; the first twenty.
std::string list_of(std::span<const std::string> names);

/// Letters, digits, `_` and `-`, at most 64: safe in column names, file names and HDF5 paths.
bool is_identifier(std::string_view name);

}  // namespace trajan
