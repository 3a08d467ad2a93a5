#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/materials/linear_elastic.h"
#include "solver/materials/neo_hookean.h"

namespace trajan {
namespace {

using Tensor = PlaneTensor<double>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double values[] = {1000, 0.3};

Tensor rotation(double angle) { return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)}; }

TEST(Logarithm, IsThatOfTheLibraryToAFewUnitsInTheLastPlace) {
  for (double x = 0x1p-40; x < 0x1p40; x *= 1.0173) {
    // Near 1 the logarithm is small and its error that of x's own rounding.
    const double tolerance = 3 * epsilon * std::max(std::abs(std::log(x)), 0x1p-30);
    EXPECT_NEAR(natural_logarithm(x), std::log(x), tolerance) << x;
  }
  EXPECT_EQ(natural_logarithm(1), 0);
}

TEST(LinearElastic, TurnsTheStressWithARigidRotationAndDoesNothingElse) {
  const LinearElastic law(values, Dimension::plane_strain);
  SymmetricTensor<double> stress{3, -1, 2, 0.5};
  double volume = 1;
  const Tensor q = rotation(0.7);
  law.advance<Dimension::plane_strain>(Tensor{q.xx - 1, q.xy, q.yx, q.yy - 1}, stress, volume);
  const Tensor turned = product(product(q, Tensor{3, 2, 2, -1}), Tensor{q.xx, q.yx, q.xy, q.yy});
  // The rotation's strain is zero up to rounding, which the modulus magnifies.
  const double tolerance = 16 * epsilon * 1000;
  EXPECT_NEAR(stress.xx, turned.xx, tolerance);
  EXPECT_NEAR(stress.yy, turned.yy, tolerance);
  EXPECT_NEAR(stress.xy, turned.xy, tolerance);
  EXPECT_NEAR(stress.zz, 0.5, tolerance);
  EXPECT_NEAR(volume, 1, 4 * epsilon);
}

TEST(LinearElastic, HasTheStressOfHookesLawAtSmallStrain) {
  const Tensor strain{1e-9, 2e-9, 2e-9, -3e-9};
  // What is quadratic in the strain is 1e-9 of the answer.
  const double tolerance = 1e-7 * 1e-6;
  const double lambda = 1000 * 0.3 / (1.3 * 0.4), mu = 1000 / 2.6;
  SymmetricTensor<double> s{0, 0, 0, 0};
  double volume = 1;
  LinearElastic(values, Dimension::plane_strain).advance<Dimension::plane_strain>(strain, s, volume);
  EXPECT_NEAR(s.xx, lambda * -2e-9 + 2 * mu * 1e-9, tolerance);
  EXPECT_NEAR(s.xy, 2 * mu * 2e-9, tolerance);
  EXPECT_NEAR(s.zz, lambda * -2e-9, tolerance);

  s = {0, 0, 0, 0};
  volume = 1;
  LinearElastic(values, Dimension::plane_stress).advance<Dimension::plane_stress>(strain, s, volume);
  EXPECT_NEAR(s.xx, 1000 / 0.91 * (1e-9 - 0.3 * 3e-9), tolerance);
  EXPECT_NEAR(s.yy, 1000 / 0.91 * (-3e-9 + 0.3 * 1e-9), tolerance);
  EXPECT_EQ(s.zz, 0);
}

/// The law's stress is the derivative of its energy: d W = P : d F, checked by central differences.
template <Dimension D>
void expect_stress_from_energy(double poissons_ratio) {
  const double moduli[] = {1000, poissons_ratio};
  const NeoHookean law(moduli, D);
  const Tensor f{1.2, 0.3, -0.1, 0.9};
  const auto energy = [&](const Tensor& at) { return law.response<D>(at).energy; };
  const SymmetricTensor<double> tau = law.response<D>(f).kirchhoff;
  const Tensor g = inverse(f);
  // P = tau F^-T
  const Tensor p = product(Tensor{tau.xx, tau.xy, tau.xy, tau.yy}, Tensor{g.xx, g.yx, g.xy, g.yy});
  const double d = 1e-5;
  // Truncation d^2 and rounding eps / d of an energy of order 100.
  const double tolerance = 1e-6;
  EXPECT_NEAR(p.xx, (energy({f.xx + d, f.xy, f.yx, f.yy}) - energy({f.xx - d, f.xy, f.yx, f.yy})) / (2 * d),
              tolerance);
  EXPECT_NEAR(p.xy, (energy({f.xx, f.xy + d, f.yx, f.yy}) - energy({f.xx, f.xy - d, f.yx, f.yy})) / (2 * d),
              tolerance);
  EXPECT_NEAR(p.yx, (energy({f.xx, f.xy, f.yx + d, f.yy}) - energy({f.xx, f.xy, f.yx - d, f.yy})) / (2 * d),
              tolerance);
  EXPECT_NEAR(p.yy, (energy({f.xx, f.xy, f.yx, f.yy + d}) - energy({f.xx, f.xy, f.yx, f.yy - d})) / (2 * d),
              tolerance);
}

TEST(NeoHookean, HasTheStressThatIsTheDerivativeOfItsEnergy) {
  expect_stress_from_energy<Dimension::plane_strain>(0.3);
  // In plane stress the derivative is right only if the out-of-plane stress vanishes.
  for (double poissons_ratio : {0.0, 0.3, 0.45})
    expect_stress_from_energy<Dimension::plane_stress>(poissons_ratio);
}

TEST(NeoHookean, IsStressFreeAtRestAndAfterARotation) {
  for (double angle : {0.0, 1.0, 2.5}) {
    const auto r = NeoHookean(values, Dimension::plane_stress).response<Dimension::plane_stress>(rotation(angle));
    EXPECT_NEAR(r.kirchhoff.xx, 0, 8 * epsilon * 1000);
    EXPECT_NEAR(r.kirchhoff.yy, 0, 8 * epsilon * 1000);
    EXPECT_NEAR(r.kirchhoff.xy, 0, 8 * epsilon * 1000);
    EXPECT_NEAR(r.energy, 0, 8 * epsilon * 1000);
  }
}

TEST(NeoHookean, FindsTheOutOfPlaneStretchForAreasFromAQuarterToFourTimes) {
  const double lambda = 1000 * 0.3 / (1.3 * 0.4), mu = 1000 / 2.6;
  const NeoHookean law(values, Dimension::plane_stress);
  for (double area : {0.25, 0.5, 0.9, 1.1, 2.0, 4.0}) {
    const double side = std::sqrt(area);
    const double volume = law.response<Dimension::plane_stress>(Tensor{side, 0, 0, side}).volume_ratio;
    const double stretch = volume / area;
    // tau_zz at the answer, whose terms are of the size of the moduli.
    EXPECT_NEAR(mu * (stretch * stretch - 1) + lambda * std::log(volume), 0, 16 * epsilon * 1000) << area;
  }
}

}  // namespace
}  // namespace trajan
