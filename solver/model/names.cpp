#include "solver/model/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <numeric>

namespace trajan {

namespace {

constexpr std::size_t longest_name = 64;
constexpr std::size_t longest_text = 80;

/// Insertions, deletions, substitutions and swaps of neighbours (optimal string alignment distance),
/// without regard to case.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [&](std::size_t i, std::size_t j) {
    return std::tolower(static_cast<unsigned char>(a[i])) == std::tolower(static_cast<unsigned char>(b[j]));
  };
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), current(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    current[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      current[j + 1] = std::min({last[j] + (same(i, j) ? 0 : 1), last[j + 1] + 1, current[j] + 1});
      if (i > 0 && j > 0 && same(i, j - 1) && same(i - 1, j)) {
        current[j + 1] = std::min(current[j + 1], before_last[j - 1] + 1);
      }
    }
    before_last.swap(last);
    last.swap(current);
  }
  return last[b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  if (name.empty() || name.size() > longest_name) return {};
  // A third of the letters may be wrong: more finds names that have nothing to do with it.
  std::size_t nearest = std::max<std::size_t>(1, name.size() / 3) + 1;
  const std::string* best = nullptr;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > 2 * longest_name) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < nearest && distance < candidate.size()) {
      nearest = distance;
      best = &candidate;
    }
  }
  return best == nullptr ? "" : "did you mean " + quoted(*best) + "?";
}

std::vector<std::string> nearest_first(std::string_view name, std::span<const std::string> candidates) {
  if (name.empty() || name.size() > longest_name) return {candidates.begin(), candidates.end()};
  struct Ranked {
    std::size_t rank;
    const std::string* candidate;
  };
  std::vector<Ranked> ranked;
  for (const std::string& candidate : candidates) {
    const bool contains = candidate.find(name) != std::string::npos;
    ranked.push_back({contains ? 0 : 1 + edit_distance(name, candidate.substr(0, 2 * longest_name)), &candidate});
  }
  std::ranges::stable_sort(ranked, {}, &Ranked::rank);
  std::vector<std::string> sorted;
  for (const Ranked& entry : ranked) sorted.push_back(*entry.candidate);
  return sorted;
}

std::string shortened(std::string_view text) {
  if (text.size() <= longest_text) return std::string(text);
  std::size_t end = longest_text;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)) + "...";
}

std::string quoted(std::string_view text) { return '"' + shortened(text) + '"'; }

std::string plural(const std::string& noun) {
  return noun.ends_with('y') ? noun.substr(0, noun.size() - 1) + "ies" : noun + "s";
}

std::string number_text(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string point_text(Vector point, int axes) {
  std::string text = "(";
  text.append(number_text(point.x));
  if (axes > 1) text.append(", ").append(number_text(point.y));
  if (axes > 2) text.append(", ").append(number_text(point.z));
  return text.append(")");
}

std::string list_of(std::span<const std::string> names) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < names.size() && i < most; ++i)
    list.append(i > 0 ? ", " : "").append(shortened(names[i]));
  return names.size() > most ? list + ", ..." : list;
}

bool is_identifier(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

}  // namespace trajan
