#include <gtest/gtest.h>

#include <algorithm>

#include "solver/materials/damaged.h"
#include "solver/materials/linear_elastic.h"
#include "solver/materials/neo_hookean.h"
#include "tests/unit/materials/one_point.h"

namespace trajan::test {
namespace {

using Rock = Damaged<LinearElastic>;
/// Marble in MPa: strength f and shape m.
constexpr double youngs = 22200, nu = 0.25, strength = 120, shape = 3;
constexpr double values[] = {youngs, nu, strength, not_given, shape, 0, 1, not_given, 0};
const Rock rock(values, 1);
const double peak = strength * std::pow(std::exp(1) * shape, -1 / shape);
const double strain_at_peak = strength * std::pow(shape, -1 / shape) / youngs;

double mid_strain(double g) { return g / (1 + 0.5 * g); }
double curve(double elastic) { return elastic * std::exp(-std::pow(elastic / strength, shape)); }

TEST(WeibullDamage, FollowsTheCurveOfTheDissertationInUniaxialCompression) {
  OnePoint<Rock, 1> column(rock);
  double strain = 0, highest = 0, strain_of_highest = 0;
  for (int i = 0; i < 1000; ++i) {
    column.pull(-1e-5);
    strain -= mid_strain(-1e-5);
    // Rounding of the strain, times the modulus.
    EXPECT_NEAR(-column.axial(), curve(youngs * strain), 1e4 * epsilon * youngs * strain);
    if (-column.axial() > highest) highest = -column.axial(), strain_of_highest = strain;
  }
  EXPECT_NEAR(highest, peak, 1e-5 * peak);
  EXPECT_NEAR(strain_of_highest, strain_at_peak, 1e-5);
}

TEST(WeibullDamage, StaysWhenTheLoadGoes) {
  OnePoint<Rock, 1> column(rock);
  for (int i = 0; i < 400; ++i) column.pull(-1e-5);
  const double stress = column.axial(), damage = column.history(0), dissipated = column.dissipated();
  double strain = 0;
  for (int i = 0; i < 400; ++i) {
    column.pull(1e-5);
    strain += mid_strain(1e-5);
    EXPECT_EQ(column.history(0), damage);
    EXPECT_NEAR(column.axial(), stress + (1 - damage) * youngs * strain, 1e-10 * strength);
  }
  EXPECT_NEAR(column.stored(), 0, 1e-6 * dissipated);
  // It comes back to where it was along the same line, and on along the curve.
  for (int i = 0; i < 400; ++i) column.pull(-1e-5);
  EXPECT_NEAR(column.axial(), stress, 2e-5 * strength);
  EXPECT_NEAR(column.history(0), damage, 1e-5);
  column.pull(-1e-4);
  EXPECT_GT(column.history(0), damage + 1e-3);
}

TEST(WeibullDamage, DissipatesWhatItDoesNotStore) {
  const auto error = [](int steps) {
    OnePoint<Rock, 1> column(rock);
    double work = 0;
    for (int i = 0; i < steps; ++i) {
      const double before = column.axial() * column.state().volume_ratio, g = -0.01 / steps;
      column.pull(g);
      work += 0.5 * (before + column.axial() * column.state().volume_ratio) * mid_strain(g);
    }
    return std::abs(work - column.stored() - column.dissipated()) / work;
  };
  // Of first order in the step, but for changes of volume of 1e-2 by which stresses per current and reference
  // volume differ.
  EXPECT_LT(error(1000), 5e-3);
}

TEST(WeibullDamage, LeavesTheOtherDirectionOfStressAlone) {
  OnePoint<Rock, 1> column(rock);
  double strain = 0;
  for (int i = 0; i < 100; ++i) {
    column.pull(1e-5);
    strain += mid_strain(1e-5);
  }
  EXPECT_EQ(column.history(0), 0);
  EXPECT_NEAR(column.axial(), youngs * strain, 1e-10 * strength);
}

TEST(WeibullDamage, IsDrivenByTensionWhereAskedTo) {
  const double brittle[] = {youngs, nu, not_given, 8, shape, 0, 1, not_given, 0};
  const Rock law(brittle, 1);
  OnePoint<Rock, 1> column(law);
  double strain = 0;
  for (int i = 0; i < 100; ++i) {
    column.pull(1e-5);
    strain += mid_strain(1e-5);
    const double elastic = youngs * strain;
    // A millionth of the stiffness always stays.
    EXPECT_NEAR(column.axial(), elastic * std::exp(-std::pow(elastic / 8, shape)), 1e-6 * elastic);
  }
}

TEST(WeibullDamage, ActsOnAHyperelasticLawAlike) {
  const Damaged<NeoHookean> law(values, 1);
  const NeoHookean base(values, 1);
  auto history = initial_history(law, 0);
  for (double axial : {0.999, 0.997, 0.995, 0.998}) {
    const Tensor<1> f{{axial, 1 + nu * (1 - axial), 1 + nu * (1 - axial)}, {}};
    const double damage = history[0];
    law.evolve(f, 1.0, history);
    const double undamaged = -base.response(f).kirchhoff.diagonal[0] / determinant(f);
    const double expected = std::max(damage, 1 - std::exp(-std::pow(undamaged / strength, shape)));
    EXPECT_NEAR(history[0], expected, 1e-13);
    EXPECT_NEAR(-law.response(f, history).kirchhoff.diagonal[0], (1 - expected) * undamaged * determinant(f),
                1e-9);
    EXPECT_NEAR(law.response(f, history).energy, (1 - expected) * base.response(f).energy, 1e-12);
  }
}

constexpr double closure = 10, open = 0.3;
constexpr double porous_values[] = {youngs, nu, 1e6, not_given, shape, closure, open, not_given, 0};

TEST(PoreClosure, StartsSoftAndEndsWithTheFullModulus) {
  const Rock porous(porous_values, 1);
  OnePoint<Rock, 1> column(porous);
  const double scale = 2 * closure / (1 + open), step = scale / youngs / 100;
  double strain = 0, before = 0;
  for (int i = 0; i < 300; ++i) {
    const double g = -step / (1 + 0.5 * step);
    column.pull(g);
    strain += step;
    const double x = youngs * strain / scale;
    const double expected = scale * (x < 1 ? open * x + (1 - open) * x * x / 2 : x - (1 - open) / 2);
    EXPECT_NEAR(-column.axial(), expected, 1e-9 * scale);
    const double tangent = (-column.axial() - before) / (youngs * step);
    EXPECT_NEAR(tangent, x < 1.005 ? open + (1 - open) * (x - 0.005) : 1, 1e-6);
    if (i == 99) {
      EXPECT_NEAR(-column.axial(), closure, 1e-9);
    }
    before = -column.axial();
  }
}

TEST(PoreClosure, StoresTheWorkAndGivesItBack) {
  const Rock porous(porous_values, 1);
  OnePoint<Rock, 1> column(porous);
  const double step = 2e-6;
  double work = 0;
  const auto go = [&](double g) {
    const double before = column.axial() * column.state().volume_ratio;
    column.pull(g);
    work += 0.5 * (before + column.axial() * column.state().volume_ratio) * mid_strain(g);
  };
  for (int i = 0; i < 600; ++i) {
    go(-step);
    // Stresses per reference volume differ by the elastic change of volume, up to 1e-3.
    EXPECT_NEAR(column.stored(), work, 2e-3 * work + 1e-9);
  }
  for (int i = 0; i < 600; ++i) go(step);
  EXPECT_NEAR(work, 0, 1e-5);
}

TEST(Scatter, GivesParticlesStrengthsOfAWeibullDistribution) {
  const double k = 5;
  double scattered[std::size(values)];
  std::copy(std::begin(values), std::end(values), scattered);
  scattered[7] = k;
  constexpr int count = 20000;
  for (double seed : {0.0, 1.0, 12345.0}) {
    scattered[8] = seed;
    const Rock law(scattered, 1);
    std::vector<double> strengths;
    for (std::uint64_t particle = 0; particle < count; ++particle)
      strengths.push_back(initial_history(law, particle)[2]);
    EXPECT_EQ(strengths[17], initial_history(law, 17)[2]);
    std::sort(strengths.begin(), strengths.end());
    double distance = 0;
    for (int i = 0; i < count; ++i) {
      const double exact = 1 - std::exp(-std::pow(strengths[static_cast<std::size_t>(i)], k));
      distance = std::max(
          {distance, std::abs(exact - static_cast<double>(i) / count), std::abs(exact - (i + 1.0) / count)});
    }
    // Kolmogorov and Smirnov: one sample of such a distribution in a thousand is farther away.
    EXPECT_LT(distance, 1.95 / std::sqrt(count)) << seed;
  }
}

TEST(Scatter, IsAnotherForEverySeedAndNoneIfNotAskedFor) {
  double scattered[std::size(values)];
  std::copy(std::begin(values), std::end(values), scattered);
  EXPECT_EQ(initial_history(Rock(scattered, 1), 3)[2], 1);
  scattered[7] = 5;
  const double one = initial_history(Rock(scattered, 1), 3)[2];
  scattered[8] = 1;
  EXPECT_NE(initial_history(Rock(scattered, 1), 3)[2], one);
}

}  // namespace
}  // namespace trajan::test
