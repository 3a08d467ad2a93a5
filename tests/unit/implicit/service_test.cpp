#include <gmock/gmock.h>

#include "solver/simulation/simulation.h"
#include "tests/unit/implicit/statics.h"

/// Implicit analyses go on from checkpoints, stop, and do not depend on threads; what has no answer says why.
namespace trajan {
namespace {

using namespace test;
using ::testing::HasSubstr;

Scene sheared(const std::string& scheme) {
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 2, 0.25, 0.3);
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{}}};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = "gimp";
  scene.loads = {growing(traction("block", Edge::right, {3, -2}))};
  scene.outputs.samples = 4;
  scene.analysis.kind = QuasiStatic{8};
  return scene;
}

TEST(ImplicitService, BitsDoNotDependOnThreadsOrInterruptions) {
  for (const char* scheme : {"TLMPM", "MUSL"}) {
    SCOPED_TRACE(scheme);
    expect_same_bits_always(validate(sheared(scheme)));
  }
}

TEST(ImplicitService, APieceOfWorkIsAnIteration) {
  const Model model = validate(sheared("TLMPM"));
  Simulation simulation(model, 1);
  int pieces = 1;
  while (!simulation.step()) ++pieces;
  // Two load steps until the first sample; a run may stop between any two pieces.
  EXPECT_GE(pieces, 4);
  EXPECT_EQ(simulation.steps(), pieces);
  EXPECT_GT(simulation.steps_left(), 0);
}

Divergence divergence_of(const Scene& scene) {
  const Answer answer = solve(validate(scene));
  EXPECT_EQ(answer.result.end, RunEnd::diverged);
  return answer.result.divergence.value_or(Divergence{});
}

TEST(ImplicitService, AMechanismNamesItsBodyAndMotion) {
  Scene scene = sheared("TLMPM");
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{{Axis::x}}}};
  EXPECT_THAT(divergence_of(scene).cause, HasSubstr("body \"block\" can move freely along (0, 1)"));
  scene.boundaries = {{"corner", Box{{0, 0}, {0, 0}}, Fixed{}}};
  scene.numerics.shape_functions = "linear";
  EXPECT_THAT(divergence_of(scene).cause, HasSubstr("body \"block\" can turn freely about (0, 0)"));
}

TEST(ImplicitService, LoadsBeyondTheLimitNameTheirFactor) {
  // By P = E/2 (s^3 - s) a Saint Venant-Kirchhoff bar bears no pressure beyond E / sqrt(27), half of this.
  Scene scene = block(Dimension::bar, "st_venant_kirchhoff", 2, 0.25, 0);
  scene.loads = {growing(traction("block", Edge::right, {-2 * 100 / std::sqrt(27), 0}))};
  scene.analysis.kind = QuasiStatic{20};
  const Divergence divergence = divergence_of(scene);
  EXPECT_THAT(divergence.cause, HasSubstr("load factor 0.5"));
  EXPECT_THAT(divergence.cause, HasSubstr("body \"block\""));
  // Steps are halved ten times from a twentieth.
  EXPECT_NEAR(divergence.time, 0.5, 1e-3);
}

// By Euler a column of 2 by 1, held at one end, buckles at pi^2 E / 192, a third of this. It stays straight, since
// nothing disturbs it, but not in balance for long.
TEST(ImplicitService, AStraightColumnBeyondItsBucklingLoadIsNotStable) {
  Scene scene = block(Dimension::plane_stress, "st_venant_kirchhoff", 2, 0.25, 0);
  scene.boundaries = {{"clamp", Box{{-1, -1}, {0, 3}}, Fixed{}}};
  scene.loads = {growing(traction("block", Edge::right, {-0.15 * 100, 0}))};
  scene.analysis.kind = QuasiStatic{10};
  const Divergence divergence = divergence_of(scene);
  EXPECT_THAT(divergence.cause, HasSubstr("is not stable"));
  EXPECT_THAT(divergence.cause, HasSubstr("body \"block\""));
  EXPECT_LE(divergence.time, 0.5);
}

TEST(ImplicitService, WhatHasNoMeaningIsRefused) {
  Scene scene = sheared("USL");
  scene.analysis.damping = 1;
  scene.numerics.time_step = 0.1;
  scene.bodies[0].initial_velocity.x = "1";
  scene.boundaries.push_back({"ball", {}, RigidBall{{5, 2}, 0.1, {}}});
  std::vector<std::string> paths;
  try {
    validate(scene);
  } catch (const InvalidScene& invalid) {
    for (const Violation& violation : invalid.violations()) paths.push_back(violation.path);
  }
  EXPECT_THAT(paths, ::testing::IsSupersetOf({"numerics.scheme", "analysis.damping", "numerics.time_step",
                                              "bodies[0].initial_velocity", "boundaries[1].rigid_ball"}));
}

}  // namespace
}  // namespace trajan
