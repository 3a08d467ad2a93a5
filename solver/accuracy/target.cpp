#include "solver/accuracy/target.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "solver/accuracy/extrapolation.h"

namespace trajan::accuracy {

namespace {

constexpr double lowest_order = 0.5;
constexpr double small_step = 2.0 / 3;
constexpr double large_step = 0.5;

/// What runs cost before there are two: explicit steps in two dimensions.
constexpr double usual_exponent = 3;

double two_grid_band(const Rung& coarse, const Rung& fine) {
  const double ratio = coarse.cell_size / fine.cell_size;
  return two_grid_factor * std::abs(fine.value - coarse.value) / (std::pow(ratio, expected_order) - 1);
}

double band_without_order(std::span<const Level> levels) {
  const auto [least, most] = std::ranges::minmax_element(levels, {}, &Level::value);
  const double ratio = levels.front().cell_size / levels.back().cell_size;
  return cautious_factor * (most->value - least->value) / (std::pow(ratio, lowest_order) - 1);
}

std::optional<double> band_of(std::span<const Rung> rungs) {
  if (rungs.size() < 2) return std::nullopt;
  const double two_grid = two_grid_band(rungs[rungs.size() - 2], rungs.back());
  // Equal to the bit are values that do not feel the cells, or feel them in pairs.
  if (rungs.size() == 2) return two_grid == 0 ? std::nullopt : std::optional(two_grid);
  std::vector<Level> levels;
  for (const Rung& rung : rungs) levels.push_back({rung.cell_size, rung.value});
  const Estimate found = estimate(levels);
  if (found.behaviour == Behaviour::monotone && found.order && *found.order >= 1)
    return found.band ? std::min(*found.band, two_grid) : two_grid;
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

}  // namespace

Outlook outlook(std::span<const Rung> rungs, double tolerance) {
  assert(!rungs.empty() && tolerance > 0);
  const Rung& finest = rungs.back();
  Outlook result;
  result.band = band_of(rungs);
  if (result.band) result.band = std::max(*result.band, 0.1 * tolerance);
  const double excess = result.band ? *result.band / tolerance : 16;
  // Three times too wide is what one small step and one more level's knowledge of the order can mend.
  const bool is_near = rungs.size() >= 2 && excess * small_step * small_step <= 3;
  result.next_cell_size = finest.cell_size * (is_near ? small_step : large_step);
  const double exponent = cost_exponent(rungs);
  result.cost_of_next = finest.cost * std::pow(finest.cell_size / result.next_cell_size, exponent);
  result.cost_to_reach = finest.cost * std::pow(std::max(excess, 1.0), exponent / expected_order);
  return result;
}

}  // namespace trajan::accuracy
