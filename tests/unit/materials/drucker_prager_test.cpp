#include "solver/materials/drucker_prager.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/materials/one_point.h"

namespace trajan::test::drucker_prager_test {
namespace {

constexpr double youngs = 50e3, nu = 0.25, cohesion = 20, friction = 30, dilation = 10;
constexpr double values[] = {youngs, nu, cohesion, friction, dilation, not_given};
constexpr double degree = std::numbers::pi / 180;
const DruckerPrager law(values, 1);

TEST(DruckerPrager, PeaksInATriaxialTestWhereMohrAndCoulombDo) {
  const double sine = std::sin(friction * degree), cosine = std::cos(friction * degree);
  for (double confinement : {0.0, 10.0, 100.0}) {
    OnePoint<DruckerPrager, 1> sample(law);
    // Confinement first, then axial strain at constant lateral pressure.
    const double e = -confinement * (1 - 2 * nu) / youngs;
    sample.step({{e, e, e}, {}});
    const double lateral = sample.stress().diagonal[1];
    for (int i = 0; i < 100; ++i) sample.compress_triaxially(-1e-4, lateral);
    const double peak = lateral * (1 + sine) / (1 - sine) - 2 * cohesion * cosine / (1 - sine);
    // Lateral stress is found to rounding of strains times the modulus.
    EXPECT_NEAR(sample.axial(), peak, 1e-9 * youngs) << confinement;
  }
}

TEST(DruckerPrager, DilatesByTheDilationAngleWhileItFlows) {
  OnePoint<DruckerPrager, 1> sample(law);
  for (int i = 0; i < 100; ++i) sample.compress_triaxially(-1e-4, 0);
  const double sine = std::sin(dilation * degree), slope = 6 * sine / (std::sqrt(3) * (3 - sine));
  // At the peak all strain is plastic, along s / (2 sqrt(J_2)) + slope / 3 1, axially -1 / sqrt(3) + slope / 3.
  const double axial = -1 / std::sqrt(3) + slope / 3, lateral = 0.5 / std::sqrt(3) + slope / 3;
  // Strains of the middle configurations differ from these by half the step.
  EXPECT_NEAR(sample.lateral_step() / -1e-4, lateral / axial, 2e-4);
}

TEST(DruckerPrager, ReturnsToItsApexWhenPulledFromAllSides) {
  OnePoint<DruckerPrager, 1> sample(law);
  sample.step({{0.011, 0.010, 0.010}, {}});
  const double apex = cohesion / std::tan(friction * degree);
  EXPECT_NEAR(trace(sample.stress()) / 3, apex, 64 * epsilon * youngs);
  EXPECT_NEAR(sample.equivalent(), 0, 64 * epsilon * youngs);
}

TEST(DruckerPrager, TearsAtItsTensionCutoffAndKeepsItsShear) {
  double cut[std::size(values)];
  std::copy(std::begin(values), std::end(values), cut);
  cut[5] = 5;
  const DruckerPrager weak(cut, 1);
  // Little shear: the cut-off alone; much of it: the corner of cut-off and cone.
  const double mu = youngs / (2 * (1 + nu)), sine = std::sin(friction * degree);
  const double eta = 6 * sine / (std::sqrt(3) * (3 - sine));
  const double xi = 6 * std::cos(friction * degree) / (std::sqrt(3) * (3 - sine));
  for (double shear : {1e-5, 1e-2}) {
    OnePoint<DruckerPrager, 2> sample(weak);
    Tensor<2> g{};
    g.diagonal[0] = g.diagonal[1] = g.diagonal[2] = 0.01;
    sample.step(g);
    // More volume than the cone's flow makes by itself.
    g = {};
    for (double& d : g.diagonal) d = 0.1 * shear;
    g(0, 1) = g(1, 0) = 0.5 * shear;
    sample.step(g);
    EXPECT_NEAR(trace(sample.stress()) / 3, 5, 64 * epsilon * youngs);
    const double strength = std::sqrt(3) * (xi * cohesion - eta * 5);
    const double elastic = std::sqrt(3) * mu * shear;
    // The strain of the middle configuration is less by a share of the order of the strain.
    EXPECT_NEAR(sample.equivalent(), std::min(elastic, strength), 1e-4 * elastic) << shear;
  }
}

TEST(DruckerPrager, NeverLeavesItsYieldSurfaceAndNeverGivesEnergyBack) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const double sine = std::sin(friction * degree);
  const double eta = 6 * sine / (std::sqrt(3) * (3 - sine));
  const double xi = 6 * std::cos(friction * degree) / (std::sqrt(3) * (3 - sine));
  OnePoint<DruckerPrager, 3> sample(law);
  double dissipated = 0;
  for (int i = 0; i < 5000; ++i) {
    Tensor<3> g{};
    for (int k = 0; k < 3; ++k) g.diagonal[k] = 1e-3 * normal(random);
    for (int k = 0; k < 6; ++k) g.off[k] = 1e-3 * normal(random);
    sample.step(g);
    const double mean = trace(sample.stress()) / 3;
    EXPECT_LE(sample.equivalent() / std::sqrt(3) + eta * mean, xi * cohesion + 64 * epsilon * youngs);
    EXPECT_GE(sample.dissipated(), dissipated - 64 * epsilon);
    dissipated = sample.dissipated();
  }
}

TEST(DruckerPrager, RefusesParametersThatContradictEachOther) {
  const auto problem = [](std::initializer_list<double> given) {
    return DruckerPrager::check(given.begin(), Dimension::solid).problem;
  };
  EXPECT_EQ(problem({youngs, nu, 20, 30, 10, not_given}), "");
  EXPECT_EQ(problem({youngs, nu, 20, 30, 10, 34}), "");
  EXPECT_NE(problem({youngs, nu, 20, 30, 31, not_given}), "");
  EXPECT_NE(problem({youngs, nu, 20, 30, 10, 35}), "");
  EXPECT_NE(problem({youngs, nu, 0, 0, 0, not_given}), "");
}

}  // namespace
}  // namespace trajan::test::drucker_prager_test
