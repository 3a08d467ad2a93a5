#pragma once

#include <optional>
#include <span>

/// How a method climbs towards an answer within a tolerance.
namespace trajan::accuracy {

/// A run of a method that has ended, in any consistent units.
struct Rung {
  double cell_size = 0;  ///< > 0
  double value = 0;
  double cost = 0;  ///< core-seconds
};

struct Outlook {
  std::optional<double> band;  ///< the finest value is within this distance of the exact one; none: no claim
  double next_cell_size = 0;   ///< that should be tried next
  double cost_of_next = 0;     ///< core-seconds, expected
  double cost_to_reach = 0;    ///< of the run that should be within the tolerance, expected
};

/// Safety factor of the grid convergence index of two grids (Roache 1998), which have no order of their own.
inline constexpr double two_grid_factor = 3;

/// What a method's runs say, the coarsest first, cell sizes strictly decreasing, at least one; the tolerance is
/// absolute. The band is
/// - of two runs, or of three and more that converge with at least the first order: the grid convergence index of
///   the two finest with the expected order, or that of `estimate` where it is narrower;
/// - of others that converge: that of `estimate`;
/// - of those that do not: three times what an error of the order 1/2 would be that makes the three finest differ
///   so much, which says something as soon as all of them are close together.
/// It is never below a tenth of the tolerance, since time steps, samples and iterations err too.
Outlook outlook(std::span<const Rung> rungs, double tolerance);

}  // namespace trajan::accuracy
