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

/// What a method climbs towards.
struct Aim {
  double tolerance = 0;  ///< > 0, absolute
  /// Smaller cells are whole parts of this length, so that bodies cut the cells of all grids alike. Otherwise
  /// errors do not fall steadily (Celik et al. 2008: refinement has to be systematic). 0: of any size.
  double unit = 0;
  /// What another method extrapolates to.
  std::optional<double> elsewhere;
  /// From cells of the unit's length to two thirds of it rather than to its half.
  bool may_be_cut_in_halves = false;
};

struct Outlook {
  std::optional<double> band;  ///< the finest value is within this distance of the exact one; none: no claim
  double next_cell_size = 0;   ///< that should be tried next
  double cost_of_next = 0;     ///< core-seconds, expected
  double cost_to_reach = 0;    ///< of the run that should be within the tolerance, expected
};

/// Safety factor of the grid convergence index of two grids (Roache 1998), which have no order of their own.
inline constexpr double two_grid_factor = 3;

/// What a method's runs say, the coarsest first, cell sizes strictly decreasing, at least one. The band is
/// - of two runs: their grid convergence index with the expected order, and how far the other method's answer is
///   away, for two runs cannot show that the order is what is expected;
/// - of three and more that converge with at least the first order: that index of the two finest, or of the finest
///   and the third, by the factor of three grids, where it is wider, or that of `estimate` where that is narrower
///   and in the asymptotic range;
/// - of others that converge: that of `estimate`;
/// - of those that do not: three times what an error of the order 1/2 would be that makes the three finest differ
///   so much, which says something as soon as all of them are close together.
/// It is never below a tenth of the tolerance, since time steps, samples and iterations err too.
Outlook outlook(std::span<const Rung> rungs, const Aim& aim);

/// The whole part of a unit that is nearest to a size below it.
double aligned(double size, double unit);

/// What smaller cells approach if two runs have the expected order.
double extrapolated(const Rung& coarse, const Rung& fine);

}  // namespace trajan::accuracy
