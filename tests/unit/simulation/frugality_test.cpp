#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(Memory, DoesNotDependOnTheSizeOfTheDomain) {
  Scene scene = test::discs(0.04);
  const Model small = validate(scene);
  scene.domain.lower = {-4000, -4000};
  scene.domain.upper = {4000, 4000};
  const Model large = validate(scene);
  // Cells are numbered from another corner, which cuts the discs into tiles differently.
  EXPECT_LT(Simulation(large, 1).executor().memory(), Simulation(small, 1).executor().memory() * 3 / 2);
}

TEST(Memory, IsUnder200BytesAParticleForAHundredThousand) {
  const Model model = validate(test::discs(1.0 / 320));
  const Simulation simulation(model, 1);
  EXPECT_LE(simulation.executor().memory(), 200u * static_cast<std::size_t>(model.particle_count()));
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
