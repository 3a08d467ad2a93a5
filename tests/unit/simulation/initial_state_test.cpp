#include <gtest/gtest.h>

#include <cmath>

#include "tests/epsilon.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

using test::epsilon;

/// A free block of mass 4 with its centre at (1, 0.5).
Scene block(const std::string& scheme, const std::string& law) {
  Scene scene;
  scene.name = "block";
  scene.domain = {Dimension::plane_strain, {-10, -10}, {10, 10}, 0.5, 1};
  scene.materials = {test::material(law, 100, 0.3, 2)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {2, 1}}, 2, {}}};
  scene.analysis = {0.5, 0};
  scene.numerics.scheme = scheme;
  scene.outputs.samples = 10;
  scene.outputs.probes = {{"all", Region{Box{{-1, -1}, {3, 3}}}, {Field::stress}, ""}};
  return scene;
}

test::Memory record(const Model& model) {
  test::Memory memory;
  EXPECT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  return memory;
}

TEST(InitialState, StressIsTheOneAskedFor) {
  Scene scene = block("MUSL", "linear_elastic");
  scene.bodies[0].initial_stress.components = {"1 + x", "2", "3", "4 * y"};
  const Model model = validate(scene);
  const std::vector<double> first = record(model).rows[0];
  // Means of linear functions over a lattice that is symmetric to the block's centre, of 32 particles.
  const double rounding = 32 * epsilon;
  EXPECT_NEAR(first[test::column(model, "all.stress.xx")], 2, 2 * rounding);
  EXPECT_NEAR(first[test::column(model, "all.stress.yy")], 2, 2 * rounding);
  EXPECT_NEAR(first[test::column(model, "all.stress.zz")], 3, 3 * rounding);
  EXPECT_NEAR(first[test::column(model, "all.stress.xy")], 2, 2 * rounding);
}

TEST(InitialState, DeformationHasTheStressOfTheLaw) {
  Scene scene = block("MUSL", "neo_hookean");
  scene.bodies[0].initial_deformation.components[0] = "1.1";
  const Model model = validate(scene);
  const std::vector<double> first = record(model).rows[0];
  const double mu = 100 / 2.6, lambda = 100 * 0.3 / (1.3 * 0.4), j = 1.1;
  // tau = mu (F F^T - 1) + lambda ln J, over J; a few operations on numbers of size mu.
  EXPECT_NEAR(first[test::column(model, "all.stress.xx")], (mu * (j * j - 1) + lambda * std::log(j)) / j,
              mu * 32 * epsilon);
  EXPECT_NEAR(first[test::column(model, "all.stress.yy")], lambda * std::log(j) / j, mu * 32 * epsilon);
}

TEST(BodyForce, OfPlaceActsInTheConfigurationThatItIsGivenIn) {
  for (const char* scheme : {"MUSL", "TLMPM"}) {
    for (const bool reference : {false, true}) {
      Scene scene = block(scheme, "neo_hookean");
      scene.bodies[0].initial_velocity.x = "3";
      LoadDefinition load;
      load.name = "source";
      load.kind = BodyForce{{}, {}, {std::nullopt, "0.1 * x * t"}, reference};
      scene.loads = {load};
      const Model model = validate(scene);
      test::Memory memory;
      const RunResult result = run(model, {}, memory, nullptr);
      const double t = scene.analysis.end_time, mass = 4, centre = 1;
      // The rate of the momentum is 0.1 t times the sum of m x, of which the centre moves at 3.
      const double exact = 0.1 * mass * (centre * t * t / 2 + (reference ? 0.0 : 3 * t * t * t / 3));
      // The trapezoidal rule has the error t dt^2 f'' / 12, here with f'' = 0.6 m or 0; the rest is rounding.
      const double dt = t / static_cast<double>(result.progress.step);
      const double error = reference ? 0 : t * dt * dt * 0.6 * mass / 12;
      EXPECT_NEAR(memory.rows.back()[test::column(model, "momentum.y")], exact + error, 1e-12)
          << scheme << reference;
    }
  }
}

}  // namespace
}  // namespace trajan
