#include "solver/model/model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/model/sample_scene.h"

namespace trajan {
namespace {

using testing::ElementsAre;

TEST(Model, GridIsExtendedUpwardsToWholeCells) {
  Scene scene = sample_scene();
  scene.domain.upper = {9.01, 2};
  const Grid grid = validate(scene).grid;
  EXPECT_EQ(grid.origin.x, -1);
  EXPECT_EQ(grid.cells_x, 41);
  EXPECT_EQ(grid.cells_y, 12);
}

TEST(Model, WholeNumbersOfCellsSurviveRounding) {
  Scene scene = sample_scene();
  // 3 / 0.1 and 10 / 0.1 are not whole numbers in binary.
  scene.domain.cell_size = 0.1;
  const Grid grid = validate(scene).grid;
  EXPECT_EQ(grid.cells_x, 100);
  EXPECT_EQ(grid.cells_y, 30);
}

TEST(Model, ParticlesAreNumberedBodyByBody) {
  const Model model = validate(sample_scene());
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(model.bodies[0].first_particle, 0);
  EXPECT_EQ(model.bodies[0].particles, 512);
  EXPECT_EQ(model.bodies[1].first_particle, 512);
  EXPECT_EQ(model.particle_count(), 512 + model.bodies[1].particles);
}

TEST(Model, ParticlesShareTheVolumeOfTheirBody) {
  Scene scene = sample_scene();
  scene.domain.thickness = 0.2;
  const Model model = validate(scene);
  EXPECT_DOUBLE_EQ(512 * model.bodies[0].particle_volume, 8 * 0.2);
  const double spacing = 0.25 / 3;
  EXPECT_DOUBLE_EQ(model.bodies[1].particle_volume, spacing * spacing * 0.2);
}

PrescribedMotion motion(const Model& model, std::size_t condition) {
  return std::get<PrescribedMotion>(model.conditions.at(condition).kind);
}

TEST(Model, RegionsOfNodesAreClippedToTheGrid) {
  Scene scene = sample_scene();
  scene.boundaries[0].nodes = Box{{-100, 0.5 - 1e-12}, {0.1, 0.5 + 1e-12}};
  scene.boundaries[1].nodes = Disc{{9, 2}, 0.25};
  const Model model = validate(scene);
  const NodeRegion& box = motion(model, 0).nodes;
  EXPECT_EQ(std::vector<std::int64_t>({box.i0, box.i1, box.j0, box.j1}), (std::vector<std::int64_t>{0, 4, 6, 6}));
  EXPECT_FALSE(box.shape);
  const NodeRegion& disc = motion(model, 1).nodes;
  EXPECT_EQ(std::vector<std::int64_t>({disc.i0, disc.i1, disc.j0, disc.j1}),
            (std::vector<std::int64_t>{39, 40, 11, 12}));
  EXPECT_TRUE(disc.shape);
}

TEST(Model, ConditionsLeaveComponentsFreeThatAreNotGiven) {
  Scene scene = sample_scene();
  scene.boundaries[0].condition = Fixed{{Axis::y}};
  const Model model = validate(scene);
  EXPECT_FALSE(motion(model, 0).components[0]);
  EXPECT_EQ((*motion(model, 0).components[1])({}, 1), 0);
  EXPECT_FALSE(motion(model, 1).components[0]);
  EXPECT_DOUBLE_EQ((*motion(model, 1).components[1])({}, std::numbers::pi / 2), 0.1);
  scene.boundaries[0].condition = Fixed{};
  EXPECT_TRUE(motion(validate(scene), 0).components[0]);
}

TEST(Model, HistoriesHaveTheColumnsOfProbesThenTheWhole) {
  EXPECT_THAT(history_columns(validate(sample_scene())),
              ElementsAre("tip.displacement.x", "tip.displacement.y", "tip.velocity.x", "tip.velocity.y",
                          "root.stress.xx", "root.stress.yy", "root.stress.xy", "root.stress.zz",
                          "energies.kinetic", "energies.strain", "energies.work", "energies.dissipated",
                          "energies.total", "energies.balance_error", "momentum.x", "momentum.y"));
}

TEST(Model, ProbesFollowTheNearestParticleOrAllOfARegion) {
  Scene scene = sample_scene();
  scene.outputs.probes[0].where = Vector{4, 1.6};
  const Model model = validate(scene);
  ASSERT_EQ(model.outputs.probes[0].particles.size(), 1u);
  EXPECT_GE(model.outputs.probes[0].particles[0], 512) << "the ball is nearer than the beam";
  EXPECT_EQ(model.outputs.probes[1].particles.size(), 64u);
  EXPECT_EQ(model.outputs.probes[1].statistic, Statistic::mean);
  scene.outputs.probes[0].body = "beam";
  EXPECT_LT(validate(scene).outputs.probes[0].particles.at(0), 512);
}

TEST(Model, ProbeOfARegionWithoutShapeFollowsAllParticles) {
  Scene scene = sample_scene();
  scene.outputs.probes[1].where = Region{};
  scene.outputs.probes[1].statistic = Statistic::largest;
  EXPECT_EQ(validate(scene).outputs.probes[1].particles.size(), 512u);
  scene.outputs.probes[1].body = "";
  const Model model = validate(scene);
  EXPECT_EQ(std::ssize(model.outputs.probes[1].particles), model.particle_count());
  EXPECT_EQ(model.outputs.probes[1].statistic, Statistic::largest);
}

TEST(Model, NumbersHaveAColumnWithoutComponent) {
  Scene scene = sample_scene();
  scene.outputs.probes[0].fields = {Field::pressure, Field::velocity};
  scene.measures.clear();
  EXPECT_EQ(history_columns(validate(scene))[0], "tip.pressure");
  EXPECT_EQ(history_columns(validate(scene))[1], "tip.velocity.x");
}

TEST(Model, SnapshotsHavePositionsAndVelocitiesOnlyOnce) {
  Scene scene = sample_scene();
  scene.outputs.snapshot_fields = {Field::position, Field::strain, Field::velocity};
  const Model model = validate(scene);
  ASSERT_EQ(model.outputs.snapshot_fields.size(), 1u);
  EXPECT_EQ(model.outputs.snapshot_fields[0].name, "strain");
  EXPECT_EQ(model.outputs.snapshot_fields[0].width(), 4u);
}

TEST(Model, SnapshotsAreTenOrTheNearestSmallerDivisor) {
  Scene scene = sample_scene();
  EXPECT_EQ(validate(scene).outputs.samples_per_snapshot, 20);
  scene.outputs.samples = 33;
  EXPECT_EQ(validate(scene).outputs.samples_per_snapshot, 11);
  scene.outputs.samples = 37;
  EXPECT_EQ(validate(scene).outputs.samples_per_snapshot, 37);
  scene.outputs.snapshots = 0;
  EXPECT_EQ(validate(scene).outputs.samples_per_snapshot, 0);
}

TEST(Model, MeasuresKnowTheirColumnAndExactValue) {
  const Model model = validate(sample_scene());
  EXPECT_EQ(model.measures.at(0).column, 1u);
  EXPECT_DOUBLE_EQ(model.measures[0].exact.value(), -4 * 512 / 3000.0);
  EXPECT_EQ(model.measures[0].until, 10);
  EXPECT_FALSE(model.measures[1].exact);
}

TEST(Model, MaterialParametersAreInTheOrderOfTheirLaw) {
  const Material material = validate(sample_scene()).materials.at(0);
  ASSERT_NE(material.kind, nullptr);
  ASSERT_EQ(material.parameters.size(), material.kind->parameters.size());
  for (std::size_t i = 0; i < material.parameters.size(); ++i) {
    EXPECT_EQ(material.parameters[i], material.kind->parameters[i].name == "youngs_modulus" ? 3000 : 0.3);
  }
}

}  // namespace
}  // namespace trajan
