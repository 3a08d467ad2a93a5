#pragma once

#include <array>

#include "solver/materials/weibull_damage.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Texts and tables put together when the program is compiled.
template <std::size_t Length>
struct FixedText {
  char characters[Length] = {};
  constexpr operator std::string_view() const { return {characters, Length}; }
};
template <class Base>
constexpr auto damaged_name() {
  FixedText<Base::name.size() + damage_prefix.size()> text;
  std::size_t i = 0;
  for (char c : damage_prefix) text.characters[i++] = c;
  for (char c : Base::name) text.characters[i++] = c;
  return text;
}
template <class Base>
constexpr auto damaged_parameters() {
  std::array<Parameter, std::size(Base::parameters) + weibull_damage_count> all{};
  std::size_t i = 0;
  for (const Parameter& one : Base::parameters) all[i++] = one;
  for (const Parameter& one : weibull_damage_parameters) all[i++] = one;
  return all;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
