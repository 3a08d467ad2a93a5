#include "solver/accuracy/target.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "solver/accuracy/extrapolation.h"

namespace trajan::accuracy {

namespace {

constexpr double small_step = 2.0 / 3;
constexpr double large_step = 0.5;

/// What runs cost before there are two: explicit steps in two dimensions.
constexpr double usual_exponent = 3;

/// Orders that a third grid confirms. Of 231 triples of grids of the gallery's scenes 143 answers claimed 0.5 %
/// with this width, of which one was further off, and 139 with that of `estimate`, the same one among them.
bool is_about_expected(double order) { return std::abs(order - expected_order) <= 0.25 * expected_order; }

/// The distance from the finer value to what smaller cells approach by an order.
double remaining(const Rung& coarse, const Rung& fine, double order) {
  return std::abs(fine.value - coarse.value) / (std::pow(coarse.cell_size / fine.cell_size, order) - 1);
}

double two_grid_band(const Rung& coarse, const Rung& fine, double factor = two_grid_factor) {
  return factor * remaining(coarse, fine, expected_order);
}

double band_without_order(std::span<const Level> levels) {
  const auto [least, most] = std::ranges::minmax_element(levels, {}, &Level::value);
  const double ratio = levels.front().cell_size / levels.back().cell_size;
  return cautious_factor * (most->value - least->value) / (std::pow(ratio, lowest_order) - 1);
}

std::optional<double> band_of(std::span<const Rung> rungs, const std::optional<double>& elsewhere) {
  if (rungs.size() < 2) return std::nullopt;
  const double two_grid = two_grid_band(rungs[rungs.size() - 2], rungs.back());
  // Equal to the bit are values that do not feel the cells, or feel them in pairs.
  if (rungs.size() == 2) {
    if (two_grid == 0) return std::nullopt;
    return two_grid + (elsewhere ? std::abs(rungs.back().value - *elsewhere) : 0);
  }
  std::vector<Level> levels;
  for (const Rung& rung : rungs) levels.push_back({rung.cell_size, rung.value});
  const Estimate found = estimate(levels);
  if (found.behaviour == Behaviour::monotone && found.order && *found.order >= 1) {
    // A last difference that is smaller than the expected order makes it may be so by accident.
    const double index =
        std::max(two_grid, two_grid_band(rungs[rungs.size() - 3], rungs.back(), asymptotic_factor));
    if (!found.asymptotic && !is_about_expected(*found.order)) return index;
    const double order = std::min(*found.order, expected_order);
    return std::min(asymptotic_factor * remaining(rungs[rungs.size() - 2], rungs.back(), order), index);
  }
  if (found.band) return found.band;
  return band_without_order(std::span(levels).last(3));
}

/// Costs grow with this power of the cells' number along an axis.
double cost_exponent(std::span<const Rung> rungs) {
  if (rungs.size() < 2) return usual_exponent;
  const Rung& coarse = rungs[rungs.size() - 2];
  const Rung& fine = rungs.back();
  const double exponent = std::log(fine.cost / coarse.cost) / std::log(coarse.cell_size / fine.cell_size);
  // Of short runs the most is start-up.
  return std::isfinite(exponent) ? std::clamp(exponent, 1.5, 5.0) : usual_exponent;
}

/// Cells below `size`, about as large as wanted, that are whole multiples or parts of the unit.
double next_size(double size, double wanted, const Aim& aim) {
  constexpr double rounding = 1e-9;
  const double unit = aim.unit;
  if (unit == 0) return wanted;
  if (wanted > (1 - rounding) * unit) return unit * std::floor(wanted / unit + rounding);
  const double parts = std::floor(unit / wanted + 0.5 + rounding);
  const double present = std::floor(unit / size + rounding);
  const bool is_unit = std::abs(size - unit) <= rounding * unit;
  if (is_unit && aim.may_be_cut_in_halves && wanted > (1 - rounding) * small_step * size) return small_step * unit;
  return unit / std::max(parts, present + 1);
}

}  // namespace

double extrapolated(const Rung& coarse, const Rung& fine) {
  const double ratio = coarse.cell_size / fine.cell_size;
  return fine.value + (fine.value - coarse.value) / (std::pow(ratio, expected_order) - 1);
}

double aligned(double size, double unit) { return size < unit ? unit / std::round(unit / size) : size; }

Outlook outlook(std::span<const Rung> rungs, const Aim& aim) {
  assert(!rungs.empty() && aim.tolerance > 0 && aim.unit >= 0);
  const Rung& finest = rungs.back();
  Outlook result;
  result.band = band_of(rungs, aim.elsewhere);
  if (result.band) result.band = std::max(*result.band, 0.1 * aim.tolerance);
  const double excess = result.band ? *result.band / aim.tolerance : 16;
  // Three times too wide is what one small step and one more level's knowledge of the order can mend.
  const bool is_near = rungs.size() >= 2 && excess * small_step * small_step <= 3;
  result.next_cell_size = next_size(finest.cell_size, finest.cell_size * (is_near ? small_step : large_step), aim);
  const double exponent = cost_exponent(rungs);
  result.cost_of_next = finest.cost * std::pow(finest.cell_size / result.next_cell_size, exponent);
  result.cost_to_reach = finest.cost * std::pow(std::max(excess, 1.0), exponent / expected_order);
  return result;
}

}  // namespace trajan::accuracy
