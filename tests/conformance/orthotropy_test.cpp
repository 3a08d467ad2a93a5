#include <gtest/gtest.h>

#include "solver/materials/orthotropic_elastic.h"
#include "tests/conformance/material_point.h"

namespace trajan::test {
namespace {

constexpr double moduli[] = {1000, 300, 200, 0.3, 0.2, 0.05, 150, 100, 120, 0, 0, 0};

TEST(OrthotropicElastic, HasTheModuliAndRatiosOfItsTable) {
  const OrthotropicElastic law(moduli, 1);
  const Stress c = normal_compliance(moduli);
  for (int axis = 0; axis < 3; ++axis) {
    // The strains of a tension along the axis, by its Young's modulus and Poisson's ratios.
    Matrix f = identity<3>();
    for (int i = 0; i < 3; ++i) f.diagonal[i] += 1e-6 * moduli[axis] * c(axis, i);
    const Stress stress = law.response(f).kirchhoff;
    // What is of second order in strains of 1e-6 is of first order in the answer.
    Stress expected{};
    expected.diagonal[axis] = 1e-6 * moduli[axis];
    EXPECT_LE(largest_difference(stress, expected), 1e-5 * 1e-6 * 1000);
  }
  EXPECT_EQ(c(0, 1), -0.3 / 1000);
  EXPECT_EQ(c(1, 2), -0.2 / 300);
  EXPECT_EQ(c(0, 2), -0.05 / 200);
  for (int shear = 0; shear < 3; ++shear) {
    Matrix f = identity<3>();
    f((shear + 1) % 3, shear) = 1e-6;
    EXPECT_NEAR(law.response(f).kirchhoff.off[shear], 1e-6 * moduli[6 + shear], 1e-5 * 1e-6 * 1000);
  }
}

TEST(OrthotropicElastic, TurnsWithItsAxes) {
  double turned[12];
  std::copy(std::begin(moduli), std::end(moduli), turned);
  turned[9] = 0.4, turned[10] = -0.7, turned[11] = 1.1;
  const Matrix q = frame_axes(turned + 9);
  const Matrix f = matrix({1.2, 0.3, 0.1, -0.1, 0.9, 0.2, 0.05, -0.15, 1.1});
  // Turning the material and what happens to it turns the stress.
  const Matrix seen = product(product(q, f), transpose(q));
  const auto still = OrthotropicElastic(moduli, 1).response(f);
  const auto moved = OrthotropicElastic(turned, 1).response(seen);
  EXPECT_LE(largest_difference(moved.kirchhoff, push_forward(q, still.kirchhoff)), 1e-12 * 1000);
  EXPECT_NEAR(moved.energy, still.energy, 1e-12 * 1000);
  // The same in the plane, whose own axes turn about z.
  turned[10] = turned[11] = 0;
  Tensor<2> plane = identity<2>();
  plane(0, 0) = 1.2, plane(0, 1) = 0.3, plane(1, 0) = -0.1, plane(1, 1) = 0.9;
  Matrix solid = identity<3>();
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) solid(i, j) = plane(i, j);
  const OrthotropicElastic law(turned, 1);
  EXPECT_NEAR(law.response(plane).energy, law.response(solid).energy, 1e-12 * 1000);
}

}  // namespace
}  // namespace trajan::test
