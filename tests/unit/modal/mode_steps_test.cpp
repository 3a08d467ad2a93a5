#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/unit/implicit/statics.h"

/// Modes through the runs that the service makes.
namespace trajan {
namespace {

using namespace test;
using ::testing::HasSubstr;

/// A block that is held at its left side and pulled at its right one.
Scene pulled(const std::string& scheme, AnalysisKind kind) {
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 2, 0.25, 0.3);
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{}}};
  scene.numerics.scheme = scheme;
  scene.loads = {{"pull", traction("block", Edge::right, {-3, 0.1})}};
  scene.outputs.samples = 4;
  scene.outputs.snapshots = 4;
  scene.analysis = {4, 0, std::move(kind)};
  return scene;
}

class ModesService : public testing::TestWithParam<std::tuple<const char*, AnalysisKind>> {};

TEST_P(ModesService, BitsDoNotDependOnThreadsOrInterruptions) {
  const auto& [scheme, kind] = GetParam();
  Scene scene = pulled(scheme, kind);
  scene.domain.cell_size = 0.5;
  expect_same_bits_always(validate(scene));
}
INSTANTIATE_TEST_SUITE_P(, ModesService,
                         testing::Values(std::tuple{"TLMPM", AnalysisKind(Modal{})},
                                         std::tuple{"MUSL", AnalysisKind(Modal{})},
                                         std::tuple{"TLMPM", AnalysisKind(Buckling{})}));

TEST(Modes, RiseWithTension) {
  Scene scene = pulled("TLMPM", Modal{});
  scene.loads.clear();
  const Answer slack = solve(validate(scene));
  scene.loads = {{"pull", traction("block", Edge::right, {5, 0})}};
  const Answer tight = solve(validate(scene));
  const std::size_t frequency = column(validate(scene), "modes.frequency");
  EXPECT_GT(tight.memory.rows[1][frequency], 1.02 * slack.memory.rows[1][frequency]);
}

TEST(Modes, PrescribedMotionsStressTheBodyToo) {
  Scene scene = pulled("TLMPM", Modal{});
  scene.loads.clear();
  const std::size_t frequency = column(validate(scene), "modes.frequency");
  scene.boundaries.push_back({"right", Box{{2, -1}, {3, 3}}, Fixed{}});
  const Answer held = solve(validate(scene));
  scene.boundaries.back().condition = PrescribedDisplacement{{"0.2 * t / 4", "0", {}}};
  const Answer stretched = solve(validate(scene));
  EXPECT_GT(stretched.memory.rows[1][frequency], 1.02 * held.memory.rows[1][frequency]);
}

// All modes together move the whole mass but that of the nodes that are held, half a cell of eight.
TEST(Modes, MoveNoMoreThanTheWholeMass) {
  Scene scene = pulled("TLMPM", Modal{});
  scene.outputs.samples = 60;
  scene.outputs.snapshots = 0;
  const Model model = validate(scene);
  const Answer answer = solve(model);
  for (const char* name : {"modes.participation.x", "modes.participation.y"}) {
    double sum = 0;
    for (const std::vector<double>& row : answer.memory.rows) sum += row[column(model, name)];
    EXPECT_LE(sum, 1) << name;
    EXPECT_GE(sum, 0.8) << name;
  }
}

TEST(Modes, OfAFreeBodyBeginWithItsThreeRigidMotions) {
  Scene scene = pulled("TLMPM", Modal{});
  scene.loads.clear();
  scene.boundaries.clear();
  const Model model = validate(scene);
  const Answer answer = solve(model);
  for (int mode : {1, 2, 3}) EXPECT_EQ(answer.memory.rows.at(mode)[column(model, "modes.frequency")], 0) << mode;
  EXPECT_GT(answer.memory.rows.at(4)[column(model, "modes.frequency")], 0.1);
}

// With one particle in a cell the grid has motions that no particle feels, without mass and without stiffness.
TEST(Modes, AreFoundWithOneParticleInACell) {
  Scene scene = pulled("TLMPM", Modal{});
  scene.domain = {Dimension::plane_stress, {0, -1}, {8, 2}, 0.25, {}};
  scene.materials = {material("linear_elastic", 3000, 0.3, 1)};
  scene.bodies = {{"block", "solid", Box{{0, 0}, {8, 1}}, 1, {}}};
  scene.boundaries = {{"left", Box{{0, -1}, {0, 2}}, Fixed{{Axis::y}}},
                      {"right", Box{{8, -1}, {8, 2}}, Fixed{{Axis::y}}}};
  scene.loads.clear();
  const Model model = validate(scene);
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  // Rayleigh and Lamb; one point in each of n = 4 layers takes 1 / n^2 of the inertia of bending, half of that
  // from the frequency.
  EXPECT_NEAR(answer.memory.rows.at(2)[column(model, "modes.frequency")], 0.378553 * (1 - 1 / 32.0),
              0.01 * 0.3786);
}

TEST(Modes, AreSearchedForUntilSomebodyStopsTheRun) {
  Memory memory;
  const RunResult result =
      run(validate(pulled("TLMPM", Modal{})), {}, memory, [](const RunProgress&) { return true; });
  EXPECT_TRUE(result.end == RunEnd::stopped || memory.rows.size() == 5u) << "unless they were found before";
}

Divergence divergence_of(const Scene& scene) {
  const Answer answer = solve(validate(scene));
  EXPECT_EQ(answer.result.end, RunEnd::diverged);
  return answer.result.divergence.value_or(Divergence{});
}

TEST(Buckling, OfABodyThatNothingHoldsNamesIt) {
  Scene scene = pulled("TLMPM", Buckling{});
  scene.boundaries = {{"pin", Box{{0, 0}, {0, 0}}, Fixed{}}};
  EXPECT_THAT(divergence_of(scene).cause, HasSubstr("body \"block\" can turn"));
}

TEST(Buckling, NeedsALoad) {
  Scene scene = pulled("TLMPM", Buckling{});
  scene.loads[0].time = "4 - t";
  const Divergence divergence = divergence_of(scene);
  EXPECT_THAT(divergence.cause, HasSubstr("loads and prescribed displacements are zero at analysis.end_time, 4"));
  EXPECT_THAT(divergence.remedy, HasSubstr("ramp"));
  scene.loads.clear();
  try {
    validate(scene);
    FAIL();
  } catch (const InvalidScene& invalid) {
    ASSERT_EQ(invalid.violations().size(), 1u);
    EXPECT_EQ(invalid.violations()[0].path, "loads");
    EXPECT_THAT(invalid.violations()[0].remedy, HasSubstr("give a load"));
  }
}

TEST(Modes, MustNotBeOfAPressureThatFollowsTheSurface) {
  Scene scene = pulled("TLMPM", Modal{});
  scene.loads = {{"wind", Pressure{{"block", Edge::right, {}}, 1, "", true}}};
  try {
    validate(scene);
    FAIL() << "was taken";
  } catch (const InvalidScene& error) {
    EXPECT_THAT(error.what(), HasSubstr("loads[0].pressure.configuration"));
  }
}

TEST(ModesPlan, HasAStepForEachMode) {
  const ModelPlan planned = plan(validate(pulled("TLMPM", Modal{})));
  EXPECT_EQ(planned.steps, 4);
  EXPECT_GT(planned.memory_bytes, 80 * 9 * 4 * 8) << "a matrix at least";
}

TEST(RelaxationPlan, DoesNotDependOnTheLengthOfTime) {
  Scene scene = pulled("TLMPM", Relaxation{});
  const ModelPlan planned = plan(validate(scene));
  scene.analysis.end_time *= 100;
  const ModelPlan longer = plan(validate(scene));
  EXPECT_EQ(longer.steps, planned.steps);
  EXPECT_EQ(longer.time_step, planned.time_step);
  EXPECT_LE(planned.steps, solve(validate(scene)).result.progress.step);
}

}  // namespace
}  // namespace trajan
