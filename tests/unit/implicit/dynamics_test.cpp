#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/unit/implicit/statics.h"

namespace trajan {
namespace {

using namespace test;

/// The first axial mode of a bar of length 10 and wave speed 10 that is held at its left end: period 4.
Scene oscillating_bar(const std::string& scheme, int steps, ImplicitDynamics analysis) {
  Scene scene = block(Dimension::bar, "linear_strain_elastic", 10, 0.5, 0);
  scene.bodies[0].initial_velocity.x = "0.01*sin(pi*x/20)";
  scene.numerics.scheme = scheme;
  analysis.time_steps = steps;
  scene.analysis = {4, 0, analysis};
  scene.outputs.samples = 4;
  scene.outputs.probes = {{"end", Vector{10, 0}, {Field::displacement, Field::velocity}, ""}};
  return scene;
}

struct End {
  double displacement, velocity, balance;
};
End end_of(const Scene& scene) {
  const Model model = validate(scene);
  const Answer answer = solve(model);
  EXPECT_EQ(answer.result.end, RunEnd::finished);
  const std::vector<double>& row = answer.memory.rows.back();
  return {row[column(model, "end.displacement.x")], row[column(model, "end.velocity.x")],
          row[column(model, "energies.balance_error")]};
}

ImplicitDynamics newmark(MassMatrix mass) {
  ImplicitDynamics analysis;
  analysis.method = Newmark{};
  analysis.mass = mass;
  return analysis;
}
ImplicitDynamics alpha(double spectral_radius) {
  ImplicitDynamics analysis;
  analysis.method = GeneralizedAlpha{spectral_radius};
  return analysis;
}

TEST(ImplicitDynamics, NewmarksMethodKeepsTheEnergyOfALinearBar) {
  for (MassMatrix mass : {MassMatrix::consistent, MassMatrix::lumped})
    // Tolerance: Newton's 1e-8 of the forces, whose work it is the square of.
    EXPECT_NEAR(end_of(oscillating_bar("TLMPM", 20, newmark(mass))).balance, 0, 1e-8);
}

TEST(ImplicitDynamics, TheBarIsBackAfterAPeriod) {
  const End end = end_of(oscillating_bar("TLMPM", 160, newmark(MassMatrix::consistent)));
  // The consistent mass makes the period too short by (pi h / (2 l))^2 / 24 = 2.6e-4, steps make it longer by
  // (omega dt)^2 / 12 = 1.3e-4; a displacement of 2 pi times that of the amplitude 0.01 * 2 / pi.
  EXPECT_NEAR(end.displacement, 0, 2 * 2e-4 * 2 * std::numbers::pi * 0.02 / std::numbers::pi);
  EXPECT_NEAR(end.velocity, 0.01, 1e-3 * 0.01);
}

TEST(ImplicitDynamics, PeriodErrorsAreOfSecondOrder) {
  for (const ImplicitDynamics& analysis :
       {newmark(MassMatrix::consistent), newmark(MassMatrix::lumped), alpha(0.8), alpha(0.5)}) {
    double moved[3];
    for (int i = 0; i < 3; ++i) moved[i] = end_of(oscillating_bar("TLMPM", 40 << i, analysis)).displacement;
    // Of errors that fall by four, the next order being 1/80 of it.
    EXPECT_NEAR((moved[0] - moved[1]) / (moved[1] - moved[2]), 4, 0.3);
  }
}

TEST(ImplicitDynamics, DampingIsThatOfTheSpectralRadius) {
  // The lowest frequency is hardly damped, and less the nearer the spectral radius is to 1.
  double lost[3];
  int i = 0;
  for (double radius : {1.0, 0.8, 0.0}) lost[i++] = -end_of(oscillating_bar("TLMPM", 40, alpha(radius))).balance;
  EXPECT_NEAR(lost[0], 0, 1e-8);
  EXPECT_GT(lost[1], 1e-5);
  EXPECT_LT(lost[1], 1e-3);
  EXPECT_GT(lost[2], 10 * lost[1]);
}

TEST(ImplicitDynamics, LongStepsLeaveTheRadiusPerStepOfFastMotions) {
  // Steps of 25 periods. The radius is a double root: the amplitude falls as n times its n-th power.
  Scene scene = oscillating_bar("TLMPM", 12, alpha(0.5));
  scene.analysis.end_time = 1200;
  scene.outputs.samples = 12;
  const Model model = validate(scene);
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  const std::size_t total = column(model, "energies.total");
  // The ratio of energies is the square; what is beside the leading term is of order 1 / n^2.
  const double ratio = answer.memory.rows[12][total] / answer.memory.rows[11][total];
  EXPECT_NEAR(ratio, 0.25 * std::pow(12.0 / 11, 2), 0.03);
}

TEST(ImplicitDynamics, BothConfigurationsAgree) {
  End ends[2];
  for (int i = 0; i < 2; ++i) {
    Scene scene = oscillating_bar(i == 0 ? "TLMPM" : "MUSL", 80, newmark(MassMatrix::consistent));
    scene.materials[0].law = "neo_hookean";
    scene.numerics.shape_functions = "quadratic_bspline";
    ends[i] = end_of(scene);
  }
  // Particles hand on what the grid forgets: a share of about (k h)^2 = 0.6 % at 20 cells in a quarter wave.
  EXPECT_NEAR(ends[1].velocity, ends[0].velocity, 0.02 * 0.01);
  EXPECT_NEAR(ends[1].displacement, ends[0].displacement, 0.05 * 0.0064);
}

TEST(ImplicitDynamics, GoesOnFromCheckpointsWithTheSameBits) {
  for (const char* scheme : {"TLMPM", "MUSL"}) {
    Scene scene = oscillating_bar(scheme, 8, alpha(0.8));
    scene.materials[0].law = "neo_hookean";
    const Model model = validate(scene);
    Memory whole, resumed;
    RunOptions options;
    options.checkpoint_interval = 0;
    run(model, options, whole, {});
    ASSERT_EQ(whole.rows.size(), 5u);
    options.resume = whole.checkpoints.at(1);
    resumed.rows = {whole.rows.begin(), whole.rows.begin() + 3};
    run(model, options, resumed, {});
    EXPECT_EQ(resumed.rows, whole.rows) << scheme;
  }
}

}  // namespace
}  // namespace trajan
