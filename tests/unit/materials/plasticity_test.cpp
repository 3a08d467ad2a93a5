#include <gtest/gtest.h>

#include "solver/materials/von_mises.h"
#include "tests/unit/materials/one_point.h"

namespace trajan::test::von_mises_test {
namespace {

constexpr double youngs = 200e3, nu = 0.3, yield = 250, hardening = 2000;
constexpr double values[] = {youngs, nu, yield, hardening};
const VonMises law(values, 1);

/// The strain that a step of this displacement gradient adds.
double mid_strain(double g) { return g / (1 + 0.5 * g); }

TEST(VonMises, FollowsTheStressStrainCurveOfUniaxialTension) {
  OnePoint<VonMises, 1> bar(law);
  double strain = 0;
  for (int i = 0; i < 40; ++i) {
    bar.pull(5e-4);
    strain += mid_strain(5e-4);
    const double elastic = youngs * strain, tangent = youngs * hardening / (youngs + hardening);
    const double expected = elastic < yield ? elastic : yield + tangent * (strain - yield / youngs);
    // Loading is radial, for which the return is exact in steps of any size; rounding of strains is magnified
    // by the modulus.
    EXPECT_NEAR(bar.axial(), expected, 64 * epsilon * youngs) << strain;
    EXPECT_NEAR(bar.history(0), elastic < yield ? 0 : strain - expected / youngs, 64 * epsilon);
  }
}

TEST(VonMises, UnloadsElasticallyAndYieldsAgainAtTheHardenedStress) {
  OnePoint<VonMises, 1> bar(law);
  for (int i = 0; i < 20; ++i) bar.pull(5e-4);
  const double peak = bar.axial(), strain = bar.history(0);
  bar.pull(-1e-4);
  EXPECT_NEAR(bar.axial(), peak + youngs * mid_strain(-1e-4), 64 * epsilon * youngs);
  EXPECT_EQ(bar.history(0), strain);
  for (int i = 0; i < 60 && bar.history(0) == strain; ++i) bar.pull(-1e-4);
  // The step of 1e-4 in which it yields again raises the yield stress by less than its share of the tangent.
  EXPECT_LE(bar.axial(), -peak);
  EXPECT_GT(bar.axial(), -peak - 1e-4 * 2 * hardening);
}

TEST(VonMises, ReachesTheSamePointOfARadialPathInOneStepAsInMany) {
  const double shear = 0.004, mu = youngs / (2 * (1 + nu));
  const auto strained = [&](int steps) {
    OnePoint<VonMises, 3> point(law);
    // Strains of the middle configurations that sum up to +shear and -shear.
    const double e = shear / steps;
    for (int i = 0; i < steps; ++i) {
      Tensor<3> g{};
      g.diagonal[0] = e / (1 - 0.5 * e);
      g.diagonal[1] = -e / (1 + 0.5 * e);
      point.step(g);
    }
    return point;
  };
  const double trial = std::sqrt(3) * 2 * mu * shear;
  const double plastic = (trial - yield) / (3 * mu + hardening);
  for (int steps : {1, 10}) {
    const auto point = strained(steps);
    EXPECT_NEAR(point.history(0), plastic, 64 * epsilon);
    EXPECT_NEAR(point.equivalent(), yield + hardening * plastic, 64 * epsilon * youngs);
    // Plastic flow leaves the volume to elasticity, and there is no pressure.
    EXPECT_NEAR(trace(point.stress()), 0, 64 * epsilon * youngs);
  }
}

TEST(VonMises, SpendsAllWorkOnStoredAndDissipatedEnergy) {
  const auto error = [](int steps) {
    OnePoint<VonMises, 3> point(law);
    double work = 0;
    for (int i = 0; i < steps; ++i) {
      // A path that turns, in strain and in rotation.
      const double t = (i + 0.5) / steps, h = 0.01 / steps;
      Tensor<3> g{};
      g.diagonal[0] = h * std::cos(3 * t);
      g.diagonal[2] = -0.7 * h;
      g(0, 1) = 2 * h * std::sin(2 * t);
      const double before_volume = point.state().volume_ratio;
      const SymmetricTensor<3> before = before_volume * point.stress();
      point.step(g);
      const SymmetricTensor<3> after = point.state().volume_ratio * point.stress();
      work += 0.5 * double_contraction(before + after, mid_strain(g));
    }
    return std::abs(work - point.stored() - point.dissipated()) / work;
  };
  // Of second order in the step but for what an elastic change of volume, some 1e-3 of the stress over the bulk
  // modulus, does to a rate form.
  EXPECT_LT(error(100), 3e-3);
  EXPECT_LT(error(400), 2e-3);
}

}  // namespace
}  // namespace trajan::test::von_mises_test
