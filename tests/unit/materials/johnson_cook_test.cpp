#include "solver/materials/johnson_cook.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/materials/one_point.h"

namespace trajan::test::johnson_cook_test {
namespace {

/// Copper of Johnson and Cook 1983, in N, mm, s and K, tonnes.
constexpr double youngs = 124e3, nu = 0.34, a = 90, b = 292, n = 0.31, c = 0.025, reference_rate = 1, m = 1.09;
constexpr double room = 298, melting = 1356, heat = 383e6, quinney = 0.9, density = 8.96e-9;
constexpr double values[] = {youngs, nu, a, b, n, c, reference_rate, m, room, melting, not_given, heat, quinney};
const JohnsonCook law(values, density);

double flow_stress(double strain, double rate, double temperature) {
  const double relative = std::max(0.0, (temperature - room) / (melting - room));
  return (a + b * std::pow(strain, n)) * (1 + c * std::log(std::max(rate / reference_rate, 1.0))) *
         (1 - std::pow(relative, m));
}

/// Uniaxial tension at a constant rate: d sigma = E (rate - p) dt, with the plastic rate p at which the flow
/// stress is sigma, by the classical Runge-Kutta rule.
struct Tension {
  double stress, strain, temperature;
};
Tension integrate(double rate, double end, int steps) {
  const auto slope = [&](const Tension& y) {
    const double still = flow_stress(y.strain, 0, y.temperature);
    const double p = y.stress > still ? reference_rate * std::exp((y.stress / still - 1) / c) : 0;
    return Tension{youngs * (rate - p), p, quinney * y.stress * p / (density * heat)};
  };
  const auto moved = [](const Tension& y, double h, const Tension& d) {
    return Tension{y.stress + h * d.stress, y.strain + h * d.strain, y.temperature + h * d.temperature};
  };
  // The plastic strain at the beginning is that of the first step; without one the slope is infinite.
  Tension y{0, 0, room};
  const double h = end / steps;
  for (int i = 0; i < steps; ++i) {
    const Tension k1 = slope(y), k2 = slope(moved(y, h / 2, k1)), k3 = slope(moved(y, h / 2, k2)),
                  k4 = slope(moved(y, h, k3));
    y = moved(moved(moved(moved(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return y;
}

TEST(JohnsonCook, ConvergesToTheOrdinaryDifferentialEquationOfTensionAtAConstantRate) {
  const double rate = 1000, end = 3e-4;
  const Tension exact = integrate(rate, end, 400000);
  ASSERT_GT(exact.strain, 0.29);
  ASSERT_GT(exact.temperature, room + 15);
  const auto error = [&](int steps) {
    OnePoint<JohnsonCook, 1> bar(law);
    const double dt = end / steps, e = rate * dt;
    for (int i = 0; i < steps; ++i) bar.pull(e / (1 - 0.5 * e), dt);
    EXPECT_NEAR(bar.history(0), exact.strain, 1e-3);
    EXPECT_NEAR(bar.history(1), exact.temperature, 0.5);
    return std::abs(bar.axial() / exact.stress - 1);
  };
  const double coarse = error(250), fine = error(1000);
  // The rule is of first order: a quarter of the step, a quarter of the error.
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, coarse / 3);
}

TEST(JohnsonCook, EndsEveryStepOnItsYieldSurface) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int sample = 0; sample < 2000; ++sample) {
    const double dt = std::pow(10, -9 + 6 * unit(random)), g = std::pow(10, -6 + 5 * unit(random));
    RateState<1, double, 3> state{{}, 1, {}};
    state.history = {unit(random) < 0.3 ? 0 : std::pow(10, -8 + 8 * unit(random)), room + 900 * unit(random), 0};
    const double strain = state.history[0], temperature = state.history[1];
    state.stress.diagonal[0] = flow_stress(strain, 0, temperature);
    advance_state(law, Tensor<1>{{g, -0.5 * g, -0.5 * g}, {}}, dt, state);
    const SymmetricTensor<1> s = deviator(state.stress);
    const double increment = state.history[0] - strain;
    const double equivalent = std::sqrt(1.5 * double_contraction(s, s));
    // The increment is known but for the rounding of the strain that it is added to.
    const double blur = 4 * epsilon * strain / std::max(increment, 1e-300);
    const double rounding = 1e-12 + (strain > 0 ? 0.1 * blur : 0);
    EXPECT_NEAR(equivalent / flow_stress(state.history[0], increment / dt, temperature), 1, rounding)
        << strain << ' ' << g << ' ' << dt;
  }
}

TEST(JohnsonCook, HeatsByItsShareOfThePlasticWork) {
  OnePoint<JohnsonCook, 1> bar(law);
  for (int i = 0; i < 100; ++i) bar.pull(1e-3, 1e-6);
  EXPECT_NEAR(bar.history(1) - room, quinney * bar.dissipated() / (density * heat), 1e-10);
  EXPECT_GT(bar.history(1), room + 3);
}

TEST(JohnsonCook, HasNoStrengthBeyondItsMeltingPoint) {
  OnePoint<JohnsonCook, 1> cold(law);
  RateState<1, double, 3> state = cold.state();
  state.history[1] = melting + 1;
  advance_state(law, Tensor<1>{{1e-3, 0, 0}, {}}, 1e-6, state);
  const SymmetricTensor<1> s = deviator(state.stress);
  EXPECT_NEAR(std::sqrt(double_contraction(s, s)), 0, 16 * epsilon * youngs);
  EXPECT_GT(trace(state.stress), 0);
}

TEST(JohnsonCook, RefusesToMeltBelowItsReferenceTemperature) {
  double bad[std::size(values)];
  std::copy(std::begin(values), std::end(values), bad);
  EXPECT_EQ(JohnsonCook::check(values, Dimension::solid).problem, "");
  bad[9] = room - 1;
  EXPECT_NE(JohnsonCook::check(bad, Dimension::solid).problem, "");
}

}  // namespace
}  // namespace trajan::test::johnson_cook_test
