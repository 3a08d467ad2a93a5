#include <gtest/gtest.h>

#include "solver/materials/ideal_gas.h"
#include "solver/materials/tait_fluid.h"
#include "tests/unit/materials/one_point.h"

namespace trajan::test {
namespace {

constexpr double bulk = 2000, exponent = 7, viscosity = 3;

/// One step to a volume ratio.
template <class Point>
void squeeze_to(Point& point, double volume_ratio, double dt = 1) {
  Tensor<1> g{};
  g.diagonal[0] = volume_ratio / point.state().volume_ratio - 1;
  point.step(g, dt);
}
template <class Point>
double pressure(const Point& point) {
  return -trace(point.stress()) / 3;
}

TEST(TaitFluid, HasThePressureOfItsEquationOfState) {
  const double values[] = {bulk, exponent, 0, -not_given};
  const TaitFluid law(values, 1);
  OnePoint<TaitFluid, 1> point(law);
  EXPECT_EQ(pressure(point), 0);
  for (double j : {0.999, 0.9, 1.05, 0.8}) {
    squeeze_to(point, j);
    EXPECT_NEAR(pressure(point), bulk / exponent * (std::pow(1 / j, exponent) - 1), 16 * epsilon * bulk * 5);
  }
}

TEST(TaitFluid, StoresTheWorkOfCompressionAlsoBeyondTheVolumeAtWhichItTears) {
  const double values[] = {bulk, exponent, 0, -50};
  const TaitFluid law(values, 1);
  for (double end : {0.85, 1.01, 1.1}) {
    OnePoint<TaitFluid, 1> point(law);
    double work = 0;
    constexpr int steps = 2000;
    for (int i = 1; i <= steps; ++i) {
      const double before = pressure(point), j = point.state().volume_ratio;
      squeeze_to(point, 1 + (end - 1) * i / steps);
      work -= 0.5 * (before + pressure(point)) * (point.state().volume_ratio - j);
    }
    // The trapezoidal rule's error, (end - 1)^3 / 12 steps^2 times the curvature, some 60 bulk moduli, and where
    // the fluid tears a kink within one step.
    EXPECT_NEAR(point.stored(), work, bulk * std::abs(end - 1) / steps * 0.15 / steps * 8) << end;
    EXPECT_GT(point.stored(), 0);
  }
}

TEST(TaitFluid, BearsNoTensionIfItMustNot) {
  const double values[] = {bulk, exponent, 0, 0};
  const TaitFluid law(values, 1);
  OnePoint<TaitFluid, 1> point(law);
  squeeze_to(point, 1.2);
  EXPECT_EQ(pressure(point), 0);
  EXPECT_EQ(point.stored(), 0);
  squeeze_to(point, 0.99);
  EXPECT_GT(pressure(point), 0);
}

TEST(TaitFluid, ShearsAndHeatsByItsViscosity) {
  const double values[] = {bulk, exponent, viscosity, -not_given};
  const TaitFluid law(values, 1);
  OnePoint<TaitFluid, 2> point(law);
  const double rate = 0.5, dt = 0.01;
  Tensor<2> g{};
  g(0, 1) = rate * dt;
  for (int i = 0; i < 100; ++i) point.step(g, dt);
  // A step's simple shear by s is strain and rotation together: 1e-5 of it is s^2 / 4.
  EXPECT_NEAR(point.stress()(0, 1), viscosity * rate, 1e-5 * viscosity * rate);
  EXPECT_NEAR(pressure(point), 0, 16 * epsilon * bulk);
  EXPECT_NEAR(point.dissipated(), viscosity * rate * rate * 100 * dt, 3e-5 * point.dissipated());
  // Stress follows the rate alone.
  point.step({}, dt);
  EXPECT_EQ(point.stress()(0, 1), 0);
}

TEST(TaitFluid, FeelsNoTurns) {
  const double values[] = {bulk, exponent, viscosity, -not_given};
  const TaitFluid law(values, 1);
  OnePoint<TaitFluid, 2> point(law);
  Tensor<2> g{};
  g.diagonal[0] = g.diagonal[1] = std::cos(0.1) - 1;
  g(1, 0) = std::sin(0.1);
  g(0, 1) = -g(1, 0);
  point.step(g);
  EXPECT_NEAR(point.stress()(0, 0), 0, 16 * epsilon * bulk);
  EXPECT_NEAR(point.stress()(0, 1), 0, 16 * epsilon * bulk);
}

TEST(IdealGas, KeepsItsAdiabatToSecondOrder) {
  const double gamma = 1.4, values[] = {gamma, 100, 0, 0};
  const IdealGas law(values, 1);
  const auto error = [&](double end, int steps) {
    OnePoint<IdealGas, 1> point(law);
    for (int i = 1; i <= steps; ++i) squeeze_to(point, 1 + (end - 1) * i / steps);
    return std::abs(pressure(point) * std::pow(end, gamma) / 100 - 1);
  };
  for (double end : {0.2, 3.0}) {
    EXPECT_LT(error(end, 100), 1e-3) << end;
    // Half the step, a quarter of the error but for terms of higher order.
    EXPECT_LT(error(end, 200), error(end, 100) / 3.8) << end;
  }
}

TEST(IdealGas, TurnsWorkIntoInternalEnergyToTheLastDigit) {
  const double values[] = {1.4, 100, 30, 0};
  const IdealGas law(values, 1);
  OnePoint<IdealGas, 1> point(law);
  double work = 0;
  for (int i = 1; i <= 50; ++i) {
    const double before = pressure(point), j = point.state().volume_ratio;
    squeeze_to(point, 1 - 0.01 * i);
    work -= 0.5 * (before + pressure(point)) * (point.state().volume_ratio - j);
  }
  EXPECT_NEAR(point.stored(), work, 64 * epsilon * 100);
}

TEST(IdealGas, ResistsSuddenCompressionByTheArtificialPressureAlone) {
  const double length = 0.2, density = 3, values[] = {1.4, 100, 0, length};
  const IdealGas law(values, density);
  const double dt = 1e-3, rate = -20;
  for (double sign : {1.0, -1.0}) {
    OnePoint<IdealGas, 1> point(law);
    // Its rate of volume is that over the middle of the step.
    squeeze_to(point, (1 + 0.5 * sign * rate * dt) / (1 - 0.5 * sign * rate * dt), dt);
    const double j = point.state().volume_ratio;
    const double q = sign > 0 ? density / j * length * length * rate * rate : 0;
    EXPECT_NEAR(pressure(point) - 0.4 * point.history(0) / j, q, 1e-10);
  }
}

TEST(Fluids, AreNotForPlanesOrBarsWithoutStressAcross) {
  for (Dimension dimension : {Dimension::bar, Dimension::plane_stress}) {
    EXPECT_NE(TaitFluid::objection(dimension, false), "");
    EXPECT_NE(IdealGas::objection(dimension, false), "");
  }
  EXPECT_EQ(TaitFluid::objection(Dimension::axisymmetric, false), "");
}

}  // namespace
}  // namespace trajan::test
