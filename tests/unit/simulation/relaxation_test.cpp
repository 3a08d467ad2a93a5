#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

using testing::HasSubstr;

constexpr double density = 2, gravity = 0.001, stiff = 100, soft = 1;

/// A rod of two metres that hangs by its own weight, its upper half a hundred times stiffer than the lower one.
Scene rod(const std::string& scheme) {
  Scene scene;
  scene.name = "rod";
  scene.domain = {Dimension::bar, {0}, {3}, 0.1, {}, {}};
  scene.materials = {test::material("linear_elastic", stiff, 0, density),
                     test::material("linear_elastic", soft, 0, density)};
  scene.materials[1].name = "soft";
  scene.bodies = {{"upper", "solid", Box{{0}, {1}}, 2, {}}, {"lower", "soft", Box{{1}, {2}}, 2, {}}};
  scene.boundaries = {{"ceiling", Box{{0}, {0}}, Fixed{}}};
  scene.loads = {{"gravity", BodyForce{{gravity}, {}}, Ramp{0, 1, false}}};
  scene.analysis = {1, 0, Relaxation{1e-7}};
  scene.numerics.scheme = scheme;
  scene.outputs.samples = 4;
  scene.outputs.snapshots = 1;
  scene.outputs.probes = {{"end", Vector{2}, {Field::displacement}, ""}};
  return scene;
}

/// Of the particle a quarter of a cell above the end. Linear functions find exact displacements of nodes.
double exact_displacement() {
  const auto of_node = [](double x) {
    return density * gravity * (1.5 / stiff + (2 * (x - 1) - (x * x - 1) / 2) / soft);
  };
  return 0.25 * of_node(1.9) + 0.75 * of_node(2);
}

TEST(Relaxation, RecordsTheForceOfItsSupports) {
  Scene scene = rod("TLMPM");
  scene.outputs.reactions = {"ceiling"};
  const Model model = validate(scene);
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  for (std::size_t level = 0; level <= 4; ++level) {
    const double weight = 2 * density * gravity * static_cast<double>(level) / 4;
    // The residual is 1e-7 of the forces on single nodes.
    EXPECT_NEAR(memory.rows.at(level)[test::column(model, "reactions.ceiling.x")], -weight, 1e-5 * weight);
  }
}

class RelaxedRod : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Schemes, RelaxedRod, testing::Values("USL", "MUSL", "USF", "USAVG", "TLMPM"),
                         [](const auto& named) { return named.param; });

// Waves are ten times as fast in one half: inertia differs, and weight does not.
TEST_P(RelaxedRod, HangsAsStaticsSaysAtEveryLevelOfItsLoad) {
  const Model model = validate(rod(GetParam()));
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  for (std::size_t level = 1; level <= 4; ++level) {
    const std::vector<double>& row = memory.rows.at(level);
    // Strains are up to 2e-3 under the whole load, and those of rates, which are logarithmic, differ from small
    // ones by half of that. The residual leaves less than 1e-5.
    const double tolerance = 1e-5 + 1e-3 * static_cast<double>(level) / 4;
    const double exact = exact_displacement() * static_cast<double>(level) / 4;
    EXPECT_NEAR(row[test::column(model, "end.displacement.x")], exact, tolerance * exact);
    EXPECT_LE(row[test::column(model, "relaxation.residual")], 1e-7);
    EXPECT_GT(row[test::column(model, "relaxation.steps")], 20) << "a wave needs longer through the rod";
    EXPECT_EQ(row[test::column(model, "energies.kinetic")], 0);
    // Of the order of the strains. Without the half kick before a halt it would be a twentieth.
    EXPECT_NEAR(row[test::column(model, "energies.balance_error")], 0, 2e-3);
  }
}

// Smooth functions give particles less than a tenth of what nodes move by in their shortest waves. The energy of
// the nodes' velocities had its maxima where the force became less, which stopped particles again and again.
TEST(Relaxation, StopsParticlesWhereTheirOwnEnergyIsLargest) {
  Scene scene = rod("MUSL");
  scene.bodies.pop_back();
  scene.numerics.shape_functions = "quadratic_bspline";
  scene.outputs.samples = 1;
  scene.outputs.probes.clear();
  const Model model = validate(scene);
  test::Memory memory;
  ASSERT_EQ(run(model, {}, memory, nullptr).end, RunEnd::finished);
  // A wave takes 20 steps through the rod, the slowest motion of the outermost node ten times as long; seven
  // powers of ten take some of these.
  EXPECT_LT(memory.rows.at(1)[test::column(model, "relaxation.steps")], 2000);
}

/// The divergence that a relaxation ends with.
Divergence failure(const Scene& scene) {
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  EXPECT_EQ(result.end, RunEnd::diverged);
  return result.divergence.value_or(Divergence{});
}

TEST(Relaxation, SaysThatWhatNothingHoldsNeverRests) {
  Scene scene = rod("TLMPM");
  scene.boundaries.clear();
  std::get<Relaxation>(scene.analysis.kind).most_steps = 500;
  const Divergence divergence = failure(scene);
  EXPECT_EQ(divergence.step, 499);
  EXPECT_THAT(divergence.cause, HasSubstr("body \"upper\" can move freely along (1)"));
  EXPECT_THAT(divergence.cause, HasSubstr("not come to rest"));
  EXPECT_THAT(divergence.remedy, HasSubstr("hold it"));
}

TEST(Relaxation, WarnsOfWhatRestsThoughNothingHoldsIt) {
  Scene scene = rod("TLMPM");
  scene.boundaries.clear();
  scene.loads.clear();
  const Model model = validate(scene);
  test::Memory memory;
  const RunResult result = run(model, {}, memory, nullptr);
  EXPECT_EQ(result.end, RunEnd::finished);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(result.warnings[0].cause, HasSubstr("body \"upper\" can move freely along (1): nothing holds it"));
}

TEST(Relaxation, DoesNotWaitForTheLastStepToSaySo) {
  Scene scene = rod("TLMPM");
  scene.boundaries.clear();
  const Divergence divergence = failure(scene);
  EXPECT_THAT(divergence.cause, HasSubstr("body \"upper\" can move freely along (1)"));
  // Nor does a domain that repeats itself hold it.
  scene.domain.upper = {6.4};
  scene.boundaries = {{"ring", {}, Periodic{Axis::x}}};
  EXPECT_THAT(failure(scene).cause, HasSubstr("body \"upper\" can move freely along (1)"));
  // Waves of 0.7 m/s take 20 steps of half the limit through the longer half; 64 times that.
  EXPECT_LT(divergence.step, 5000);
}

// Two blocks of a few cells in contact. Their strains of 1e-9, which the law finds as what deformations are more
// than 1, have seven digits, and twelve are asked for.
TEST(Relaxation, EndsWhereItMakesNoMoreProgressAndSaysWhere) {
  Scene scene = rod("MUSL");
  scene.domain = {Dimension::plane_strain, {0, 0}, {1, 2}, 0.25, 1, {}};
  scene.bodies = {{"lower", "soft", Box{{0.25, 0}, {0.75, 0.5}}, 2, {}},
                  {"upper", "soft", Box{{0.25, 0.5}, {0.75, 1}}, 2, {}}};
  for (MaterialDefinition& definition : scene.materials) definition.law = "neo_hookean";
  scene.contacts.emplace_back();
  scene.boundaries = {{"ground", Box{{0, 0}, {1, 0}}, Fixed{}}};
  scene.loads = {{"gravity", BodyForce{{0, -1e-6 * gravity}, {}}, 1.0}};
  scene.analysis = {1, 0, Relaxation{1e-12}};
  const Divergence divergence = failure(scene);
  EXPECT_THAT(divergence.cause, HasSubstr("the relaxation is stuck after"));
  EXPECT_THAT(divergence.cause, HasSubstr("1e-12 is asked for), most in body \""));
  EXPECT_THAT(divergence.remedy, HasSubstr("analysis.relaxation.tolerance"));
  EXPECT_GE(divergence.particle, 0);
}

TEST(Relaxation, GivesTheSameBitsOnThreadsAndFromCheckpoints) {
  Scene scene = rod("MUSL");
  std::get<Relaxation>(scene.analysis.kind).tolerance = 0.05;
  const Model model = validate(scene);
  test::Memory whole;
  ASSERT_EQ(run(model, {1, 0, {}}, whole, nullptr).end, RunEnd::finished);
  ASSERT_EQ(whole.checkpoints.size(), 3u);
  test::Memory rest;
  ASSERT_EQ(run(model, {2, 1e9, whole.checkpoints[1]}, rest, nullptr).end, RunEnd::finished);
  for (std::size_t row = 3; row <= 4; ++row) EXPECT_EQ(rest.rows.at(row), whole.rows[row]) << row;
}

TEST(Relaxation, RefusesWhatHasNoMeaningAtRest) {
  Scene scene = rod("TLMPM");
  scene.analysis = {1, 2, Relaxation{0.2, 0}};
  scene.bodies[1].initial_velocity = {"0.5"};
  scene.boundaries = {{"ceiling", Box{{0}, {0}}, PrescribedVelocity{{"0"}}},
                      {"floor", Box{{2}, {2}}, PrescribedDisplacement{{"0.1*t"}}}};
  std::vector<std::string> paths;
  try {
    validate(scene);
  } catch (const InvalidScene& invalid) {
    for (const Violation& violation : invalid.violations()) paths.push_back(violation.path);
  }
  EXPECT_THAT(paths, testing::ElementsAre("analysis.relaxation.tolerance", "analysis.relaxation.most_steps",
                                          "analysis.damping", "bodies[1].initial_velocity", "boundaries[1]"));
}

}  // namespace
}  // namespace trajan
