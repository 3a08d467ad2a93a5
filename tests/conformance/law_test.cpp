#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/conformance/material_point.h"
#include "tests/epsilon.h"

/// What every constitutive law must do. The laws come from the registry.
namespace trajan::test {
namespace {

class Law : public testing::TestWithParam<LawCase> {
 protected:
  const MaterialKind& kind() const { return *GetParam().kind; }
  Dimension dimension() const { return GetParam().dimension; }
  /// A large deformation with stretch, shear and rotation.
  Matrix deformed() const { return in(dimension(), matrix({1.2, 0.3, 0.1, -0.1, 0.9, 0.2, 0.05, -0.15, 1.1})); }
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

class TurningLaw : public Law {};
std::vector<LawCase> turning_laws() {
  std::vector<LawCase> cases = all_laws();
  std::erase_if(cases, [](const LawCase& of) { return !turns(of.dimension) || !traits_of(*of.kind).objective; });
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Registry, TurningLaw, testing::ValuesIn(turning_laws()),
                         [](const auto& named) { return name_of(named.param); });

/// Goes from the present deformation to `next` by equal steps.
void stretch(MaterialPoint& point, const Matrix& next, int steps) {
  const Matrix from = point.deformation();
  for (int i = 1; i <= steps; ++i) point.deform(from + (static_cast<double>(i) / steps) * (next - from));
}

/// Turns the point by `angle` in equal steps.
void turn(MaterialPoint& point, Dimension dimension, double angle, int steps) {
  const Matrix from = point.deformation();
  for (int i = 1; i <= steps; ++i) point.deform(product(rotation(dimension, angle * i / steps), from));
}

TEST_P(Law, HasNeitherStressNorEnergyAtRest) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const MaterialPoint point(GetParam(), parameters);
    const double rounding = 8 * epsilon * largest_modulus;
    EXPECT_LE(largest_difference(point.stress(), {}), rounding);
    const Matrix virial = point.virial();
    EXPECT_NEAR(contraction(virial, virial), 0, rounding);
    EXPECT_NEAR(point.energy(), 0, rounding);
  });
}

TEST_P(TurningLaw, FeelsNoTurns) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    constexpr int steps = 600;
    turn(point, dimension(), 3 * 2 * std::numbers::pi, steps);
    // Every step rounds the deformation gradient. A volume that changed would show as pressure.
    const double rounding = 4 * epsilon * steps * largest_modulus;
    EXPECT_LE(largest_difference(point.stress(), {}), rounding);
    EXPECT_NEAR(point.energy(), 0, rounding);
  });
}

TEST_P(TurningLaw, TurnsItsStressWithARotation) {
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    stretch(point, deformed(), 10);
    const Stress before = point.stress();
    const double energy = point.energy();
    constexpr int steps = 50;
    turn(point, dimension(), 2.5, steps);
    const double rounding = 16 * epsilon * steps * largest_modulus;
    EXPECT_LE(largest_difference(point.stress(), push_forward(rotation(dimension(), 2.5), before)), rounding);
    EXPECT_NEAR(point.energy(), energy, rounding);
  });
}

TEST_P(TurningLaw, ObservesTheSameFromATurningPlaceToSecondOrder) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const auto difference = [&](int steps) {
      MaterialPoint still(GetParam(), parameters), turning(GetParam(), parameters);
      for (int i = 1; i <= steps; ++i) {
        const double s = static_cast<double>(i) / steps;
        const Matrix f = in(
            dimension(), matrix({1 + 0.2 * s, 0.3 * s * s, 0, -0.1 * s, 1 - 0.1 * s, 0.1 * s, 0, 0, 1 + 0.1 * s}));
        still.deform(f);
        turning.deform(product(rotation(dimension(), 1.5 * s), f));
      }
      return largest_difference(turning.stress(), push_forward(rotation(dimension(), 1.5), still.stress()));
    };
    // Halving the step divides an error of second order by 4; a hyperelastic law has none but rounding.
    const double rounding = 16 * epsilon * 100 * largest_modulus;
    EXPECT_LT(difference(100), difference(50) / 3.5 + rounding);
  });
}

TEST_P(Law, HasASymmetricStressThatIsTheOneOfItsForces) {
  if (!traits_of(kind()).objective) return;
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    stretch(point, deformed(), 10);
    const Matrix virial = point.virial();
    const Stress stress = point.stress();
    const double rounding = 64 * epsilon * largest_modulus;
    // The virial is the Cauchy stress times one volume; a fluid that tears has neither.
    const bool torn = virial(0, 0) == 0 && stress(0, 0) == 0;
    const double volume = torn ? 1 : virial(0, 0) / stress(0, 0);
    EXPECT_GT(volume, 0);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        if (has(dimension(), i, j)) {
          EXPECT_NEAR(virial(i, j), volume * stress(i, j), rounding) << i << j;
        }
      }
  });
}

TEST_P(Law, IsFreeOfStressAcrossAPlaneOrBar) {
  if (!rest_is_free(dimension())) return;
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    for (const Matrix& f : {deformed(), in(dimension(), matrix({0.7, 0, 0, 0, 0.7, 0, 0, 0, 1})),
                            in(dimension(), matrix({1.2, 0, 0, 0, 1.1, 0, 0, 0, 1}))}) {
      stretch(point, f, 20);
      EXPECT_EQ(point.unsolved(), 0);
      // Work equals stress on the grid's axes alone only if nothing is done across.
      const Stress s = point.stress();
      for (int k = grid_axes(dimension()); k < 3; ++k) EXPECT_EQ(s.diagonal[k], 0);
    }
  });
}

TEST_P(Law, IsHookesAtSmallStrain) {
  if (!traits_of(kind()).hookean) return;
  for_each_sample([&](const std::vector<double>& parameters) {
    const double e = parameters[0], nu = parameters[1];
    const double lambda = e * nu / ((1 + nu) * (1 - 2 * nu)), mu = e / (2 * (1 + nu));
    Matrix strain = matrix({3e-6, 2e-6, 1e-6, 2e-6, -1e-6, -2e-6, 1e-6, -2e-6, 0.5e-6});
    strain = in(dimension(), strain + identity<3>()) - identity<3>();
    const double area = strain(0, 0) + strain(1, 1);
    if (dimension() == Dimension::plane_stress) strain(2, 2) = -nu / (1 - nu) * area;
    if (dimension() == Dimension::bar) strain(1, 1) = strain(2, 2) = -nu * strain(0, 0);
    MaterialPoint point(GetParam(), parameters);
    point.deform(strain + identity<3>());
    const Stress expected = plus_diagonal(2 * mu * symmetric_part(strain), lambda * trace(strain));
    // What is of second order in the strain is of first order, some 1e-6, in the answer.
    EXPECT_LE(largest_difference(point.stress(), expected), 1e-5 * 3e-6 * largest_modulus);
    if (!traits_of(kind()).objective) return;
    // The volume that forces are made with. Stresses are rounded to eps / 3e-6.
    const double volume = point.virial()(0, 0) / point.stress()(0, 0);
    EXPECT_NEAR(volume - 1, trace(strain), 1e-3 * 3e-6);
  });
}

TEST_P(Law, StoresTheWorkOfASmallStrain) {
  if (!traits_of(kind()).elastic) return;
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    const Matrix small = in(dimension(), matrix({1 + 3e-4, 2e-4, 0, 1e-4, 1 - 1e-4, 1e-4, 0, 1e-4, 1 + 2e-4}));
    stretch(point, small, 2);
    // Half of stress times strain, but for terms of third order.
    const double work = 0.5 * contraction(point.nominal_stress(), small - identity<3>());
    EXPECT_NEAR(point.energy(), work, 3e-3 * work);
  });
}

TEST_P(Law, ComesBackToRestFromASmallLoop) {
  if (!traits_of(kind()).elastic) return;
  for_each_sample([&](const std::vector<double>& parameters) {
    MaterialPoint point(GetParam(), parameters);
    const double e = 1e-4;
    for (const Matrix& corner :
         {matrix({1 + e, 0, 0, 0, 1, 0, 0, 0, 1}), matrix({1 + e, e, 0, 0, 1 - e, 0, e, 0, 1 + e}),
          matrix({1, e, e, 0, 1, 0, 0, 0, 1}), identity<3>()})
      stretch(point, in(dimension(), corner), 4);
    // A rate form's stress depends on the path in second order.
    EXPECT_LE(largest_difference(point.stress(), {}), 8 * e * e * largest_modulus);
  });
}

TEST_P(Law, HasTheWaveSpeedOfItsRegistryAtRest) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const double density = 2.5;
    const MaterialPoint point(GetParam(), parameters, density);
    const double speed = kind().wave_speed(parameters, density, dimension());
    EXPECT_NEAR(point.squared_wave_speed(), speed * speed, 16 * epsilon * speed * speed);
  });
}

TEST_P(Law, HasAnAcousticTensorWhoseFastestWaveIsThatOfTheRegistry) {
  for_each_sample([&](const std::vector<double>& parameters) {
    const double density = 2.5, speed = kind().wave_speed(parameters, density, dimension());
    const double modulus = density * speed * speed, rounding = 64 * epsilon * largest_modulus;
    const auto n = static_cast<std::size_t>(grid_axes(dimension()));
    double largest = 0;
    for (std::size_t axis = 0; axis < n; ++axis) {
      std::array<double, 9> tensor{};
      kind().acoustic_tensor(parameters, density, dimension(), static_cast<int>(axis), tensor);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          EXPECT_NEAR(tensor[n * i + j], tensor[n * j + i], rounding);
          // Waves along grid axes are not faster than the fastest of all.
          EXPECT_LE(tensor[n * i + j], modulus + rounding);
        }
      largest = std::max(largest, tensor[n * axis + axis]);
    }
    if (traits_of(kind()).isotropic) {
      EXPECT_NEAR(largest, modulus, rounding);
    }
  });
}

TEST_P(Law, CountsDeformationsWithoutAPositiveDeterminant) {
  const std::vector<double> parameters = sample_parameters(kind()).front();
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {-0.1, 0.0, nothing}) {
    MaterialPoint point(GetParam(), parameters);
    point.deform(in(dimension(), matrix({0.9, 0, 0, 0, 1, 0, 0, 0, 1})));
    EXPECT_EQ(point.inverted(), 0);
    point.deform(in(dimension(), matrix({bad, 0, 0, 0, 1, 0, 0, 0, 1})));
    EXPECT_EQ(point.inverted(), 1);
  }
}

}  // namespace
}  // namespace trajan::test
