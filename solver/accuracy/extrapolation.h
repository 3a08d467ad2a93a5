#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// What answers on grids of different cell sizes say of their errors.
namespace trajan::accuracy {

/// An answer on one grid, in any consistent units.
struct Level {
  double cell_size = 0;  ///< > 0
  double value = 0;
};

enum class Behaviour {
  monotone,        ///< differences have one sign and become smaller
  oscillating,     ///< differences alternate and become smaller
  not_converging,  ///< differences do not become smaller
  constant         ///< differences are those of rounding
};

struct Estimate {
  Behaviour behaviour = Behaviour::constant;
  std::optional<double> order;         ///< observed, of the three finest levels
  bool asymptotic = false;             ///< see below
  std::optional<double> extrapolated;  ///< what smaller cells approach
  std::optional<double> band;          ///< the finest value is within this distance of the exact one
  std::string no_claim;                ///< why there is no band; empty if there is one
};

/// The order of displacements and frequencies in all schemes with lumped masses.
inline constexpr double expected_order = 2;
/// What converges with a lower one is too slow for any claim.
inline constexpr double lowest_order = 0.5;

/// Safety factors of the grid convergence index (Roache 1998). The usual 1.25 in the asymptotic range holds too
/// few true errors of the gallery (tests/verification/band_table), so it is 2 here. Outside it is 3, and no order
/// above the first is trusted; where values oscillate, the last difference may be small by chance, and the one
/// before counts.
inline constexpr double asymptotic_factor = 2;
inline constexpr double cautious_factor = 3;

/// Whether a measure is a check of rest or conservation rather than an answer: an energy, a momentum, or what
/// should be 0 and is no deviation from a curve. Its exact value is not the limit of small cells (time that is too
/// short, steps that are too long and rounding remain), so that a ladder of cells says nothing of its error.
bool is_check(std::string_view quantity, std::optional<double> exact, bool is_deviation);

/// The order p of values phi = exact + C h^p, from the differences of three levels whose ratios need not be equal
/// (Celik et al. 2008, equation 3, solved by bisection): (r32^p - 1) r21^p / (r21^p - 1) = |phi3 - phi2| / |phi2 -
/// phi1|, where 1 is the finest. None if there is no p > 0.
std::optional<double> observed_order(const Level& coarse, const Level& middle, const Level& fine);

/// Richardson's extrapolation and the grid convergence index (ASME V&V 20-2009, section 2; Celik et al. 2008) of
/// at least three levels, the coarsest first, cell sizes strictly decreasing. Asymptotic is what converges
/// monotonically with an order within a tenth of the expected one, or, of four levels and more, with orders of the
/// two finest triples within a tenth of each other. No claim is made of what does not converge, does so slower
/// than with the lowest order, does not change, or is not finite.
Estimate estimate(std::span<const Level> levels);

}  // namespace trajan::accuracy
