#include "client/unit_labels.h"

#include <fmt/format.h>

#include <vector>

namespace trajan::client {
namespace {

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(' ') - begin + 1));
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

}  // namespace

UnitLabels::UnitLabels(std::string_view units) {
  constexpr std::size_t longest_name = 8;
  std::vector<std::string> names;
  while (!units.empty()) {
    const std::size_t comma = units.find(',');
    names.push_back(trimmed(units.substr(0, comma)));
    if (names.back().empty() || names.back().size() > longest_name) return;
    units = comma == std::string_view::npos ? std::string_view() : units.substr(comma + 1);
  }
  if (names.size() < 3) return;
  length_ = names[0];
  time_ = names[1];
  mass_ = names[2];
}

const UnitLabels::Derived* UnitLabels::derived() const {
  static constexpr Derived known[] = {{"m", "s", "kg", "Pa", "J", "N s", "N"},
                                      {"mm", "s", "t", "MPa", "mJ", "N s", "N"},
                                      {"mm", "ms", "g", "MPa", "mJ", "mN s", "N"},
                                      {"mm", "ms", "kg", "GPa", "J", "N s", "kN"},
                                      {"m", "ms", "t", "GPa", "GJ", "MN s", "GN"}};
  for (const Derived& units : known) {
    if (units.length == length_ && units.time == time_ && units.mass == mass_) return &units;
  }
  return nullptr;
}

std::string UnitLabels::of_column(std::string_view column) const {
  if (length_.empty() || contains(column, "balance_error")) return {};
  const Derived* named = derived();
  if (contains(column, "stress") || contains(column, "pressure")) {
    return named != nullptr ? std::string(named->stress) : fmt::format("{}/({} {}²)", mass_, length_, time_);
  }
  if (contains(column, "energies")) {
    return named != nullptr ? std::string(named->energy) : fmt::format("{} {}²/{}²", mass_, length_, time_);
  }
  if (column.starts_with("reactions.")) {
    return named != nullptr ? std::string(named->force) : fmt::format("{} {}/{}²", mass_, length_, time_);
  }
  if (contains(column, "momentum")) {
    return named != nullptr ? std::string(named->momentum) : fmt::format("{} {}/{}", mass_, length_, time_);
  }
  if (contains(column, "velocity")) return fmt::format("{}/{}", length_, time_);
  if (contains(column, "displacement") || contains(column, "position")) return length_;
  return {};
}

std::string with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : fmt::format("{} ({})", label, unit);
}

}  // namespace trajan::client
