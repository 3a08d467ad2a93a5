#include "solver/accuracy/extrapolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace trajan::accuracy {

namespace {

constexpr double cautious_order = 1;
constexpr double agreement = 0.1;

/// Of the largest magnitude: what long sums of doubles lose.
constexpr double rounding = 1e-11;

bool is_constant(std::span<const Level> levels) {
  const auto [least, most] = std::ranges::minmax_element(levels, {}, &Level::value);
  return most->value - least->value <= rounding * std::max(std::abs(least->value), std::abs(most->value));
}

bool near(double one, double other) { return std::abs(one - other) <= agreement * other; }

/// The two finest triples have the same order.
bool orders_agree(std::span<const Level> levels, double order) {
  if (levels.size() < 4) return false;
  const auto triple = levels.last(4).first(3);
  const bool same_side = (triple[0].value - triple[1].value) * (triple[1].value - triple[2].value) > 0;
  const auto before = observed_order(triple[0], triple[1], triple[2]);
  return same_side && before && near(*before, order);
}

/// The distance from the finest value to what smaller cells approach, if the order is this.
double remaining(const Level& middle, const Level& fine, double order) {
  return (fine.value - middle.value) / (std::pow(middle.cell_size / fine.cell_size, order) - 1);
}

Estimate no_claim(Behaviour behaviour, std::optional<double> order, const char* why) {
  return {behaviour, order, false, std::nullopt, std::nullopt, why};
}

}  // namespace

bool is_check(std::string_view quantity, std::optional<double> exact, bool is_deviation) {
  if (quantity.starts_with("energies.") || quantity.starts_with("momentum.")) return true;
  return exact == 0.0 && !is_deviation;
}

std::optional<double> observed_order(const Level& coarse, const Level& middle, const Level& fine) {
  const double r21 = middle.cell_size / fine.cell_size;
  const double r32 = coarse.cell_size / middle.cell_size;
  const double ratio = std::abs((coarse.value - middle.value) / (middle.value - fine.value));
  const auto excess = [&](double p) {
    return std::expm1(p * std::log(r32)) * std::pow(r21, p) / std::expm1(p * std::log(r21)) - ratio;
  };
  constexpr double highest = 30;
  double low = 1e-6;
  double high = highest;
  if (!(excess(low) < 0) || !(excess(high) > 0)) return std::nullopt;
  // The left side grows with p. Every halving gains a bit.
  for (int bit = 0; bit < 60; ++bit) {
    const double middle_order = 0.5 * (low + high);
    (excess(middle_order) < 0 ? low : high) = middle_order;
  }
  return 0.5 * (low + high);
}

Estimate estimate(std::span<const Level> levels) {
  assert(levels.size() >= 3);
  if (!std::ranges::all_of(levels, [](const Level& level) { return std::isfinite(level.value); }))
    return no_claim(Behaviour::not_converging, std::nullopt, "a value is not finite");
  if (is_constant(levels))
    return no_claim(Behaviour::constant, std::nullopt, "the values differ by rounding alone");
  const Level& coarse = levels[levels.size() - 3];
  const Level& middle = levels[levels.size() - 2];
  const Level& fine = levels.back();
  const double before = middle.value - coarse.value;
  const double last = fine.value - middle.value;
  if (last == 0) return no_claim(Behaviour::not_converging, std::nullopt, "the two finest values are equal");
  const auto order = observed_order(coarse, middle, fine);
  if (!order) return no_claim(Behaviour::not_converging, std::nullopt, "the differences do not become smaller");
  const bool monotone = before * last > 0;
  const Behaviour behaviour = monotone ? Behaviour::monotone : Behaviour::oscillating;
  if (*order < lowest_order) return no_claim(behaviour, order, "it converges too slowly");
  const bool asymptotic = monotone && (near(*order, expected_order) || orders_agree(levels, *order));
  if (!monotone) return {behaviour, order, false, fine.value, cautious_factor * std::abs(before), {}};
  const double extrapolated = fine.value + remaining(middle, fine, std::min(*order, expected_order));
  const double trusted = std::min(*order, asymptotic ? expected_order : cautious_order);
  const double factor = asymptotic ? asymptotic_factor : cautious_factor;
  return {behaviour, order, asymptotic, extrapolated, factor * std::abs(remaining(middle, fine, trusted)), {}};
}

}  // namespace trajan::accuracy
