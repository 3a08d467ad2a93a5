#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/conformance/material_point.h"

/// What every constitutive law must do. The laws come from the registry.
namespace trajan::test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// What the moduli of all samples are below; rounding errors of stresses are relative to it.
constexpr double largest_modulus = 4000;
/// A large deformation with stretch, shear and rotation.
constexpr Tensor deformed{1.2, 0.3, -0.1, 0.9};

class Law : public testing::TestWithParam<LawCase> {
 protected:
  const MaterialKind& kind() const { return *GetParam().kind; }
  bool plane_stress() const { return GetParam().dimension == Dimension::plane_stress; }
  template <class Check>
  void for_each_sample(Check&& check) const {
    for (const std::vector<double>& parameters : sample_parameters(kind())) {
      SCOPED_TRACE(testing::PrintToString(parameters));
      check(parameters);
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Registry, Law, testing::ValuesIn(all_laws()),
                         [](const auto& named) { return name_of(named.param); });

class Hyperelastic : public Law {};
INSTANTIATE_TEST_SUITE_P(Registry, Hyperelastic, testing::ValuesIn(hyperelastic_laws()),
                         [](const auto& named) { return name_of(named.param); });

/// Goes from the present deformation to `next` by equal steps.
void stretch(MaterialPoint& point, const Tensor& next, int steps) {
  const Tensor from = point.deformation();
  for (int i = 1; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps, r = 1 - s;
    point.deform({r * from.xx + s * next.xx, r * from.xy + s * next.xy, r * from.yx + s * next.yx,
                  r * from.yy + s * next.yy});
  }
}

/// Turns the point by `angle` in equal steps.
void turn(MaterialPoint& point, double angle, int steps) {
  const Tensor from = point.deformation();
  for (int i = 1; i <= steps; ++i) point.deform(product(rotation(angle * i / steps), from));
}

void expect_stress(const MaterialPoint& point, const Tensor& expected, double zz, double tolerance) {
  const std::array<double, 4> stress = point.stress();
  EXPECT_NEAR(stress[0], expected.xx, tolerance);
  EXPECT_NEAR(stress[1], expected.yy, tolerance);
  EXPECT_NEAR(stress[2], expected.xy, tolerance);
  EXPECT_NEAR(stress[3], zz, tolerance);
}

TEST_P(Law, HasNeitherStressNorEnergyAtRest) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const MaterialPoint point(GetParam(), parameters);
    const double rounding = 8 * epsilon * largest_modulus;
    expect_stress(point, {0, 0, 0, 0}, 0, rounding);
    const Tensor virial = point.virial();
    EXPECT_NEAR(contraction(virial, virial), 0, rounding);
    EXPECT_NEAR(point.energy(), 0, rounding);
  });
}

TEST_P(Law, FeelsNoFullTurn) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    constexpr int steps = 200;
    turn(point, 2 * std::numbers::pi, steps);
    // Every step rounds the deformation gradient.
    const double rounding = 4 * epsilon * steps * largest_modulus;
    expect_stress(point, {0, 0, 0, 0}, 0, rounding);
    EXPECT_NEAR(point.energy(), 0, rounding);
  });
}

TEST_P(Law, TurnsItsStressWithARotation) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    stretch(point, deformed, 10);
    const std::array<double, 4> before = point.stress();
    const double energy = point.energy();
    constexpr int steps = 50;
    turn(point, 2.5, steps);
    const Tensor q = rotation(2.5);
    const Tensor turned = product(product(q, Tensor{before[0], before[2], before[2], before[1]}), transpose(q));
    const double rounding = 16 * epsilon * steps * largest_modulus;
    expect_stress(point, turned, before[3], rounding);
    EXPECT_NEAR(point.energy(), energy, rounding);
  });
}

TEST_P(Law, ObservesTheSameFromATurningPlaceToSecondOrder) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const auto difference = [&](int steps) {
      MaterialPoint still(GetParam(), parameters), turning(GetParam(), parameters);
      for (int i = 1; i <= steps; ++i) {
        const double s = static_cast<double>(i) / steps;
        const Tensor f{1 + 0.2 * s, 0.3 * s * s, -0.1 * s, 1 - 0.1 * s};
        still.deform(f);
        turning.deform(product(rotation(1.5 * s), f));
      }
      const std::array<double, 4> a = still.stress(), b = turning.stress();
      const Tensor q = rotation(1.5);
      const Tensor turned = product(product(q, Tensor{a[0], a[2], a[2], a[1]}), transpose(q));
      return std::hypot(b[0] - turned.xx, b[1] - turned.yy, b[2] - turned.xy) + std::abs(b[3] - a[3]);
    };
    // Halving the step divides an error of second order by 4; a hyperelastic law has none but rounding.
    const double rounding = 16 * epsilon * 100 * largest_modulus;
    EXPECT_LT(difference(100), difference(50) / 3.5 + rounding);
  });
}

TEST_P(Law, HasASymmetricStress) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    stretch(point, deformed, 10);
    const Tensor virial = point.virial();
    const std::array<double, 4> stress = point.stress();
    const double rounding = 32 * epsilon * largest_modulus;
    EXPECT_NEAR(virial.xy, virial.yx, rounding);
    // Both are the Cauchy stress times one volume.
    const double volume = (virial.xx + virial.yy) / (stress[0] + stress[1]);
    EXPECT_NEAR(virial.xx, volume * stress[0], rounding);
    EXPECT_NEAR(virial.xy, volume * stress[2], rounding);
    EXPECT_GT(volume, 0);
  });
}

TEST_P(Law, IsHookesAtSmallStrain) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const double e = value_of(kind(), parameters, "youngs_modulus");
    const double nu = value_of(kind(), parameters, "poissons_ratio");
    const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
    const double exx = 3e-6, eyy = -1e-6, exy = 2e-6;
    const double ezz = plane_stress() ? -nu / (1 - nu) * (exx + eyy) : 0.0;
    const double trace = exx + eyy + ezz;
    MaterialPoint point(GetParam(), parameters);
    point.deform({1 + exx, exy, exy, 1 + eyy});
    // What is of second order in the strain is of first order, some 1e-6, in the answer.
    const double tolerance = 1e-5 * 3e-6 * largest_modulus;
    expect_stress(point,
                  {lambda * trace + 2 * mu * exx, 2 * mu * exy, 2 * mu * exy, lambda * trace + 2 * mu * eyy},
                  lambda * trace + 2 * mu * ezz, tolerance);
    // The thickness: volume over area. The stresses that it is computed from are rounded to eps / 3e-6.
    const std::array<double, 4> stress = point.stress();
    if (plane_stress()) {
      EXPECT_NEAR(stress[3], 0, 8 * epsilon * e);
    }
    const Tensor virial = point.virial();
    const double volume = (virial.xx + virial.yy) / (stress[0] + stress[1]);
    EXPECT_NEAR(volume / determinant(point.deformation()) - 1, ezz, 1e-3 * 3e-6);
  });
}

TEST_P(Law, StoresTheWorkOfASmallStrain) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    const Tensor change{3e-4, 2e-4, 1e-4, -1e-4};
    stretch(point, Tensor{1, 0, 0, 1} + change, 2);
    // Half of stress times strain, but for terms of third order.
    const double work = 0.5 * contraction(point.nominal_stress(), change);
    EXPECT_NEAR(point.energy(), work, 3e-3 * work);
  });
}

TEST_P(Law, ComesBackToRestFromASmallLoop) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    const double strain = 1e-4;
    for (const Tensor& corner : {Tensor{1 + strain, 0, 0, 1}, Tensor{1 + strain, strain, 0, 1 - strain},
                                 Tensor{1, strain, 0, 1}, Tensor{1, 0, 0, 1}})
      stretch(point, corner, 4);
    // A rate form's stress depends on the path in second order.
    expect_stress(point, {0, 0, 0, 0}, 0, 4 * strain * strain * largest_modulus);
  });
}

TEST_P(Hyperelastic, HasTheStressThatIsTheDerivativeOfItsEnergy) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    point.deform(deformed);
    const double d = 1e-5;
    const auto slope = [&](const Tensor& direction) {
      MaterialPoint ahead(GetParam(), parameters), behind(GetParam(), parameters);
      ahead.deform(deformed + direction);
      behind.deform(deformed - direction);
      return (ahead.energy() - behind.energy()) / (2 * d);
    };
    const Tensor p = point.nominal_stress();
    // Truncation d^2 times third derivatives, and rounding eps / d of energies up to some 100.
    const double tolerance = 1e-10 * largest_modulus + 4 * epsilon / d * 1000;
    EXPECT_NEAR(p.xx, slope({d, 0, 0, 0}), tolerance);
    EXPECT_NEAR(p.xy, slope({0, d, 0, 0}), tolerance);
    EXPECT_NEAR(p.yx, slope({0, 0, d, 0}), tolerance);
    EXPECT_NEAR(p.yy, slope({0, 0, 0, d}), tolerance);
  });
}

TEST_P(Hyperelastic, DoesNoWorkAroundALoop) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    constexpr int steps = 128;
    const auto path = [](int i) {
      const double t = 2 * std::numbers::pi * i / steps;
      return Tensor{1 + 0.3 * std::sin(t), 0.4 * std::cos(t), 0.2 * std::sin(t), 1.1 - 0.2 * std::cos(t)};
    };
    point.deform(path(0));
    const double energy = point.energy();
    double work = 0, moved = 0;
    for (int i = 0; i < steps; ++i) {
      point.deform(path(i));
      const double step = 0.5 * contraction(point.nominal_stress(), path(i + 1) - path(i - 1));
      work += step;
      moved += std::abs(step);
    }
    point.deform(path(steps));
    // On a smooth loop the trapezoidal rule converges faster than any power of the step: what is left is
    // rounding.
    EXPECT_NEAR(work, 0, 1e-10 * moved);
    EXPECT_NEAR(point.energy(), energy, 8 * epsilon * steps * largest_modulus);
  });
}

TEST_P(Law, HasTheWaveSpeedOfItsModulusAtRest) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const double density = 2.5, strain = 1e-6;
    MaterialPoint point(GetParam(), parameters, density);
    const double at_rest = point.squared_wave_speed();
    // A longitudinal wave strains in its direction alone.
    point.deform({1 + strain, 0, 0, 1});
    const double modulus = point.nominal_stress().xx / strain;
    // The modulus changes with the strain, by its order.
    EXPECT_NEAR(at_rest, modulus / density, 1e-5 * at_rest);
    const double speed = kind().wave_speed(parameters, density, GetParam().dimension);
    EXPECT_NEAR(at_rest, speed * speed, 16 * epsilon * at_rest);
  });
}

/// The largest squared speed of plane waves of density 1 about the point's deformation, from the acoustic
/// tensor (Ogden 1997, eq. 6.4.5), whose moduli are central differences of the nominal stress. Directions
/// are those of the reference configuration, or of the current one.
double squared_speed_of_waves(const MaterialPoint& at, const LawCase& of) {
  const Tensor f = at.deformation();
  double fastest = 0;
  for (int i = 0; i < 36; ++i) {
    const double angle = std::numbers::pi * i / 36, x = std::cos(angle), y = std::sin(angle), d = 1e-6;
    // The covector n of a wave f(n . x) in the current configuration is F^T n in the reference one.
    const double nx = of.total_lagrangian ? x : f.xx * x + f.yx * y;
    const double ny = of.total_lagrangian ? y : f.xy * x + f.yy * y;
    const auto tractions = [&](const Tensor& direction) {
      MaterialPoint ahead = at, behind = at;
      ahead.deform(f + direction);
      behind.deform(f - direction);
      const Tensor p = ahead.nominal_stress() - behind.nominal_stress();
      return std::array{(p.xx * nx + p.xy * ny) / (2 * d), (p.yx * nx + p.yy * ny) / (2 * d)};
    };
    const auto of_x = tractions({d * nx, d * ny, 0, 0}), of_y = tractions({0, 0, d * nx, d * ny});
    const double mean = 0.5 * (of_x[0] + of_y[1]), half = 0.5 * (of_x[0] - of_y[1]);
    const double square = half * half + of_x[1] * of_y[0];
    fastest = std::max(fastest, mean + std::sqrt(std::max(0.0, square)));
  }
  return fastest;
}

TEST_P(Hyperelastic, KnowsABoundOnItsWavesWhenItIsDeformed) {
  for_each_sample([&](const std::vector<double>& parameters) {
    for (const Tensor& f : {deformed, Tensor{1.5, 0, 0, 0.8}, Tensor{0.7, 0, 0, 0.9}, Tensor{1, 0.6, 0, 1},
                            Tensor{1.3, 0, 0, 1.4}}) {
      SCOPED_TRACE(testing::PrintToString(std::array{f.xx, f.xy, f.yx, f.yy}));
      MaterialPoint point(GetParam(), parameters);
      point.deform(f);
      const double waves = squared_speed_of_waves(point, GetParam());
      // Differences are accurate to 1e-6. The bound is meant for a time step, and must not be a poor one:
      // within a quarter of the speed.
      EXPECT_GE(point.squared_wave_speed(), waves * (1 - 1e-6));
      EXPECT_LE(point.squared_wave_speed(), waves * 1.25 * 1.25);
    }
  });
}

TEST_P(Law, CountsDeformationsWithoutAPositiveDeterminant) {
  const std::vector<double> parameters = sample_parameters(kind()).front();
  for (const Tensor& bad : {Tensor{-0.1, 0, 0, 1}, Tensor{0, 0, 0, 1}, Tensor{1, 2, 1, 1},
                            Tensor{std::numeric_limits<double>::quiet_NaN(), 0, 0, 1}}) {
    MaterialPoint point(GetParam(), parameters);
    point.deform({0.9, 0, 0, 1});
    EXPECT_EQ(point.inverted(), 0);
    point.deform(bad);
    EXPECT_EQ(point.inverted(), 1);
  }
}

}  // namespace
}  // namespace trajan::test
