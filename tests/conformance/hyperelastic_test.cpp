#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/materials/eigenvalues.h"
#include "tests/conformance/material_point.h"
#include "tests/epsilon.h"

/// What every law must do whose stress follows from an energy of the deformation gradient.
namespace trajan::test {
namespace {

class Hyperelastic : public testing::TestWithParam<LawCase> {
 protected:
  Dimension dimension() const { return GetParam().dimension; }
  template <class Check>
  void for_each_sample(Check&& check) const {
    for (const std::vector<double>& parameters : sample_parameters(*GetParam().kind)) {
      SCOPED_TRACE(testing::PrintToString(parameters));
      check(parameters);
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Registry, Hyperelastic, testing::ValuesIn(hyperelastic_laws()),
                         [](const auto& named) { return name_of(named.param); });

TEST_P(Hyperelastic, HasTheStressThatIsTheDerivativeOfItsEnergy) {
  const Matrix deformed = in(dimension(), matrix({1.2, 0.3, 0.1, -0.1, 0.9, 0.2, 0.05, -0.15, 1.1}));
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    point.deform(deformed);
    const Matrix p = point.nominal_stress();
    const double d = 1e-5;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (!has(dimension(), i, j)) continue;
        MaterialPoint ahead(GetParam(), parameters), behind(GetParam(), parameters);
        Matrix change{};
        change(i, j) = d;
        ahead.deform(deformed + change);
        behind.deform(deformed - change);
        // Truncation d^2 times third derivatives, and rounding eps / d of energies up to some 100.
        const double tolerance = 1e-10 * largest_modulus + 4 * epsilon / d * 1000;
        EXPECT_NEAR(p(i, j), (ahead.energy() - behind.energy()) / (2 * d), tolerance) << i << j;
      }
  });
}

TEST_P(Hyperelastic, DoesNoWorkAroundALoop) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    constexpr int steps = 128;
    const auto path = [&](int i) {
      const double t = 2 * std::numbers::pi * i / steps, s = std::sin(t), c = std::cos(t);
      return in(dimension(),
                matrix({1 + 0.3 * s, 0.4 * c, 0.1 * s, 0.2 * s, 1.1 - 0.2 * c, 0, 0.1 * c, 0, 1 + 0.1 * s}));
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

/// Unit normals all over half of what a dimension has.
std::vector<std::array<double, 3>> normals(int axes) {
  std::vector<std::array<double, 3>> normals;
  const int turns = axes > 1 ? 24 : 1, rises = axes > 2 ? 12 : 1;
  for (int i = 0; i < turns; ++i)
    for (int j = 0; j < rises; ++j) {
      const double turn = std::numbers::pi * i / turns, rise = std::numbers::pi * j / rises;
      normals.push_back({std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise)});
    }
  return normals;
}

/// The largest squared speed of plane waves of density 1 about the point's deformation, from the acoustic
/// tensor (Ogden 1997, eq. 6.4.5), whose moduli are central differences of the nominal stress. Normals are
/// those of the reference configuration, or of the current one.
double squared_speed_of_waves(const MaterialPoint& at, const LawCase& of) {
  const int axes = grid_axes(of.dimension);
  const Matrix f = at.deformation();
  const double d = 1e-6;
  double fastest = 0;
  for (const std::array<double, 3>& n : normals(axes)) {
    // The covector n of a wave f(n . x) in the current configuration is F^T n in the reference one.
    std::array<double, 3> covector{};
    for (int i = 0; i < axes; ++i)
      for (int j = 0; j < axes; ++j) covector[i] += of.total_lagrangian ? (i == j ? n[i] : 0) : f(j, i) * n[j];
    Stress acoustic{};
    for (int j = 0; j < axes; ++j) {
      Matrix change{};
      for (int i = 0; i < axes; ++i) change(j, i) = d * covector[i];
      MaterialPoint ahead = at, behind = at;
      ahead.deform(f + change);
      behind.deform(f - change);
      const Matrix p = ahead.nominal_stress() - behind.nominal_stress();
      for (int i = 0; i <= j; ++i)
        for (int k = 0; k < axes; ++k) acoustic(i, j) += p(i, k) * covector[k] / (2 * d);
    }
    for (double speed : eigenvalues(acoustic)) fastest = std::max(fastest, speed);
  }
  return fastest;
}

TEST_P(Hyperelastic, KnowsABoundOnItsWaves) {
  for_each_sample([&](const std::vector<double>& parameters) {
    for (const Matrix& of_solid :
         {identity<3>(), matrix({1.2, 0.3, 0.1, -0.1, 0.9, 0.2, 0.05, -0.15, 1.1}),
          matrix({1.5, 0, 0, 0, 0.8, 0, 0, 0, 1}), matrix({0.7, 0, 0, 0, 0.9, 0, 0, 0, 0.8}),
          matrix({1, 0.6, 0, 0, 1, 0, 0, 0.3, 1}), matrix({1.3, 0, 0, 0, 1.4, 0, 0, 0, 1.2})}) {
      const Matrix f = in(dimension(), of_solid);
      SCOPED_TRACE(testing::PrintToString(std::array{f(0, 0), f(0, 1), f(1, 0), f(1, 1), f(2, 2)}));
      MaterialPoint point(GetParam(), parameters);
      point.deform(f);
      const double waves = squared_speed_of_waves(point, GetParam());
      // Differences are accurate to 1e-6. The bound is meant for a time step, and must not be a poor one:
      // within a quarter of the speed.
      EXPECT_GE(point.squared_wave_speed(), waves * (1 - 1e-6));
      const bool at_rest = determinant(f - identity<3>()) == 0 && contraction(f, f) == 3;
      if (traits_of(*GetParam().kind).isotropic || at_rest) {
        EXPECT_LE(point.squared_wave_speed(), waves * 1.25 * 1.25);
      }
    }
  });
}

}  // namespace
}  // namespace trajan::test
