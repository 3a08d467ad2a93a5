#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trajan {

/// Edits that turn one word into the other: insertions, deletions, substitutions and swaps of neighbours
/// (optimal string alignment distance), without regard to case.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, if it is near enough to be a misspelling of it; otherwise empty.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "did you mean "x"?" if a candidate is near, otherwise `otherwise` followed by all candidates.
std::string suggest(std::string_view word, const std::vector<std::string>& candidates, std::string_view otherwise);

}  // namespace trajan
