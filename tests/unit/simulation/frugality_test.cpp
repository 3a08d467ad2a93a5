#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "solver/simulation/simulation.h"
#include "tests/unit/simulation/scenes.h"

namespace trajan {
namespace {

std::vector<std::string> attributes(const std::string& scheme, const std::string& law, Dimension dimension,
                                    const std::string& transfer = "FLIP") {
  Scene scene = test::discs(0.04);
  scene.numerics.transfer = transfer;
  scene.numerics.scheme = scheme;
  scene.materials[0].law = law;
  scene.domain.dimension = dimension;
  std::vector<std::string> names;
  for (const ModelPlan::Attribute& a : plan(validate(scene)).attributes) names.push_back(a.name);
  return names;
}

using testing::UnorderedElementsAre;

TEST(Attributes, AreThoseThatTheSceneNeeds) {
  EXPECT_THAT(attributes("MUSL", "linear_elastic", Dimension::plane_stress),
              UnorderedElementsAre("position.x", "position.y", "velocity.x", "velocity.y", "volume", "stress.xx",
                                   "stress.yy", "stress.xy", "number"));
  EXPECT_THAT(attributes("USL", "linear_elastic", Dimension::plane_strain),
              UnorderedElementsAre("position.x", "position.y", "velocity.x", "velocity.y", "volume", "stress.xx",
                                   "stress.yy", "stress.xy", "stress.zz", "number"));
  EXPECT_THAT(
      attributes("MUSL", "neo_hookean", Dimension::plane_stress),
      UnorderedElementsAre("position.x", "position.y", "velocity.x", "velocity.y", "deformation.xx",
                           "deformation.xy", "deformation.yx", "deformation.yy", "deformation.zz", "number"));
  EXPECT_THAT(attributes("TLMPM", "neo_hookean", Dimension::plane_strain),
              UnorderedElementsAre("position.x", "position.y", "velocity.x", "velocity.y", "displacement.x",
                                   "displacement.y", "deformation.xx", "deformation.xy", "deformation.yx",
                                   "deformation.yy", "number"));
}

TEST(Attributes, OfAffineVelocitiesAreThereForAffineTransfersAlone) {
  const std::vector<std::string> affine{"affine.xx", "affine.xy", "affine.yx", "affine.yy"};
  for (const char* transfer : {"FLIP", "XPIC", "FMPM"})
    EXPECT_EQ(attributes("TLMPM", "neo_hookean", Dimension::plane_strain, transfer),
              attributes("TLMPM", "neo_hookean", Dimension::plane_strain));
  EXPECT_THAT(attributes("TLMPM", "neo_hookean", Dimension::plane_strain, "APIC"), testing::IsSupersetOf(affine));
}

TEST(Attributes, AreFloatsWhereTheSceneAsksForThemButForPlacesAndVolumes) {
  Scene scene = test::discs(0.04);
  const auto bytes_of = [](const ModelPlan& of) {
    int sum = 0;
    for (const ModelPlan::Attribute& a : of.attributes) sum += a.bytes;
    return sum;
  };
  const int doubles = bytes_of(plan(validate(scene)));
  scene.numerics.precision = float_precision;
  const ModelPlan floats = plan(validate(scene));
  for (const ModelPlan::Attribute& a : floats.attributes) {
    const bool wide = a.name.starts_with("position") || a.name == "volume";
    EXPECT_EQ(a.bytes, wide ? 8 : 4) << a.name;
  }
  // Two velocities and four stresses.
  EXPECT_EQ(doubles - bytes_of(floats), 6 * 4);
  const Simulation simulation(validate(scene), 1);
  for (const BodyParticles& body : simulation.executor().bodies())
    for (int a = 0; a < attribute_count; ++a)
      EXPECT_TRUE(body.arrays[a].capacity() == 0 || body.floats[a].capacity() == 0);
}

TEST(Memory, OfNodesHasTheVectorsThatTheTransferIterates) {
  Scene scene = test::discs(0.04);
  const auto nodes = [&](const char* transfer) {
    scene.numerics.transfer = transfer;
    const Model model = validate(scene);
    const Simulation simulation(model, 1);
    // From one tile to the next.
    return simulation.executor().tiles().nodes(1) - simulation.executor().tiles().nodes(0);
  };
  EXPECT_EQ(nodes("FLIP"), tile_nodes * (1 + 2 * 3));
  EXPECT_EQ(nodes("FMPM"), tile_nodes * (1 + 2 * 4));
  EXPECT_EQ(nodes("XPIC"), tile_nodes * (1 + 2 * 5));
}

/// What a step works on: tiles, of those the ones with particles, and blocks.
std::array<std::size_t, 3> work(const Simulation& simulation) {
  const Tiles& tiles = simulation.executor().tiles();
  const auto occupied = std::ranges::count_if(tiles.tiles(), [](const Tile& tile) { return tile.window >= 0; });
  return {tiles.tiles().size(), static_cast<std::size_t>(occupied), tiles.blocks().size()};
}

TEST(Memory, AndWorkAreTheSameInADomainAMillionTimesLargerThanTheBodies) {
  // Cells of a power of two, and corners of both domains at corners of tiles: the discs are cut into tiles alike.
  Scene scene = test::discs(1.0 / 32);
  const Model small = validate(scene);
  scene.domain.lower = {-262144, -262144};
  scene.domain.upper = {262144, 262144};
  const Model large = validate(scene);
  const Simulation in_small(small, 1), in_large(large, 1);
  EXPECT_EQ(in_large.executor().memory(), in_small.executor().memory());
  EXPECT_EQ(work(in_large), work(in_small));
}

/// Attributes, stages of a step and bytes.
auto cost(const Scene& scene) {
  const ModelPlan planned = plan(validate(scene));
  std::vector<std::string> names;
  for (const auto* rows : {&planned.attributes, &planned.node_attributes})
    for (const ModelPlan::Attribute& row : *rows) names.push_back(row.name);
  for (const ModelPlan::Sweep& sweep : planned.sweeps)
    for (const ModelPlan::BodyStages& of_bodies : sweep.of_bodies)
      names.insert(names.end(), of_bodies.stages.begin(), of_bodies.stages.end());
  return std::pair(names, planned.memory_bytes);
}

TEST(Cost, HasNothingOfWhatASceneDoesNotUse) {
  const Scene scene = test::discs(0.04);
  Scene other = scene;
  other.materials.push_back({"unused", 1, "neo_hookean", {{"youngs_modulus", 1}, {"poissons_ratio", 0.3}}});
  EXPECT_EQ(cost(other), cost(scene)) << "a law that no body has";
  other = scene;
  other.boundaries = {{"wall", Edge::bottom, Fixed{}}};
  EXPECT_EQ(cost(other), cost(scene)) << "a condition on nodes";
  other = scene;
  other.outputs.probes = {{"all", Region{}, {Field::displacement, Field::stress}, ""}};
  EXPECT_EQ(cost(other), cost(scene)) << "a probe between samples";
  other = scene;
  other.numerics.transfer = "XPIC";
  EXPECT_NE(cost(other), cost(scene)) << "a transfer that iterates has its price";
}

TEST(Memory, IsUnder200BytesAParticleForAHundredThousand) {
  const Model model = validate(test::discs(1.0 / 320));
  const Simulation simulation(model, 1);
  EXPECT_LE(simulation.executor().memory(), 200u * static_cast<std::size_t>(model.particle_count()));
}

/// Would not fit into any memory, and take minutes to look at.
TEST(Plan, OfAlmostABillionParticlesLooksAtNoneOfThem) {
  const ModelPlan planned = plan(validate(test::bar("MUSL", "linear_elastic", 1.0 / 4096, 0.1)));
  EXPECT_EQ(planned.particles, std::int64_t{40960} * 4096 * 4);
  EXPECT_EQ(planned.particle_bytes, planned.particles * (8 * 8 + 4));
  EXPECT_GE(planned.tiles, planned.active_cells / tile_nodes);
  EXPECT_EQ(planned.sweeps.size(), 2u);
}

TEST(Plan, CountsParticlesCellsAndSteps) {
  const Model model = validate(test::bar("MUSL", "linear_elastic", 0.5, 0.1));
  const ModelPlan planned = plan(model);
  EXPECT_EQ(planned.particles, 40 * 4);
  EXPECT_EQ(planned.active_cells, 40);
  test::Memory memory;
  EXPECT_EQ(run(model, {}, memory, nullptr).progress.step, planned.steps);
}

}  // namespace
}  // namespace trajan
