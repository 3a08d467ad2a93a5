#include "tests/unit/model/mistake.h"

/// Scenes made to harm. What is tested is that validation ends with a violation at all: each of these
/// would run for hours or use up the memory if anything were enumerated first.
namespace trajan {
namespace {

using testing::Contains;
using testing::ElementsAre;

TEST(HostileScene, WithTooManyParticlesIsRefusedByArithmetic) {
  Scene scene = sample_scene();
  scene.domain.upper = {1e6, 1e6};
  scene.bodies[1].geometry = Box{{0, 0}, {1e6, 1e6}};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[1]"));
  scene.bodies[1].geometry = Disc{{5e5, 5e5}, 4e5};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[1]"));
}

TEST(HostileScene, WithTooManyParticlesInAllIsRefusedByArithmetic) {
  Scene scene = sample_scene();
  scene.domain.upper = {1e4, 1e4};
  scene.bodies.resize(1);
  for (int i = 0; i < 20; ++i) {
    scene.bodies.push_back({"more" + std::to_string(i), "rubber", Box{{0, 0}, {1000, 1000}}, 2, {}});
  }
  // 15 bodies of 6.4e7 particles fit into 10^9, the others do not.
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[16]", "bodies[17]", "bodies[18]", "bodies[19]", "bodies[20]"));
}

TEST(HostileScene, OfExtremeNumbersIsRefused) {
  for (const double extreme : {1e300, -1e300, 1e-300, infinity, -infinity, not_a_number, -0.0, 5e-324}) {
    Scene scene = sample_scene();
    scene.domain = {Dimension::plane_stress, {-extreme, -extreme}, {extreme, extreme}, extreme, extreme};
    scene.materials[0].density = extreme;
    scene.bodies[0].geometry = Box{{0, 0}, {extreme, extreme}};
    scene.bodies[1].geometry = Disc{{extreme, extreme}, extreme};
    scene.boundaries[0].nodes = Disc{{extreme, extreme}, extreme};
    scene.boundaries[1].nodes = Box{{-extreme, -extreme}, {extreme, extreme}};
    std::get<PointForce>(scene.loads[2].kind).position = {extreme, extreme};
    scene.analysis.end_time = extreme;
    scene.outputs.probes[0].where = Vector{extreme, -extreme};
    scene.outputs.probes[1].where = Region{Disc{{extreme, 0}, extreme}};
    scene.measures[0].from = extreme;
    EXPECT_FALSE(violations_of(scene).empty()) << extreme;
  }
}

TEST(HostileScene, OfExtremeNumbersInOnePlaceIsRefusedOrRight) {
  for (const double extreme : {1e300, -1e300, 1e9, 1e18, -1e18, infinity, not_a_number}) {
    Scene scene = sample_scene();
    scene.boundaries[0].nodes = Disc{{extreme, extreme}, 1};
    EXPECT_THAT(paths_of(scene), Contains(testing::StartsWith("boundaries[0].nodes"))) << extreme;
    scene = sample_scene();
    std::get<PointForce>(scene.loads[2].kind).position = {extreme, 0.5};
    EXPECT_THAT(paths_of(scene), Contains(testing::StartsWith("loads[2].point_force.position"))) << extreme;
    scene = sample_scene();
    scene.outputs.probes[1].where = Region{Disc{{extreme, extreme}, 1}};
    EXPECT_THAT(paths_of(scene), Contains(testing::StartsWith("outputs.probes[1].mean"))) << extreme;
    scene = sample_scene();
    scene.measures[0].from = extreme;
    EXPECT_THAT(paths_of(scene), Contains("measures[0].from")) << extreme;
  }
}

TEST(HostileScene, WithALargeGridAndRegionsOfAllOfItIsCheckedWithoutLookingAtNodes) {
  Scene scene = sample_scene();
  scene.domain.lower = {-1e8, -1e8};
  scene.domain.upper = {1e8, 1e8};
  scene.boundaries[0].nodes = Disc{{0, 0}, 1e8};
  scene.boundaries[1].nodes = Box{{-1e9, -1e9}, {1e9, 1e9}};
  EXPECT_THAT(paths_of(scene), ElementsAre());
}

TEST(HostileScene, WithProbesOfTooManyParticlesIsRefusedByArithmetic) {
  Scene scene = sample_scene();
  scene.domain.upper = {3000, 3000};
  scene.bodies[0].geometry = Box{{0, 0}, {3000, 1000}};
  scene.outputs.probes[1].where = Region{Box{{0, 0}, {3000, 3000}}};
  EXPECT_THAT(paths_of(scene), Contains("outputs.probes[1].mean"));
}

TEST(HostileScene, WithTooLongLoadedEdgesIsRefusedByArithmetic) {
  Scene scene = sample_scene();
  scene.domain.upper = {1e6, 2};
  scene.bodies[0].geometry = Box{{0, 0}, {1e6, 1}};
  std::get<EdgeTraction>(scene.loads[0].kind).edge = Edge::top;
  scene.loads.resize(2);
  EXPECT_THAT(paths_of(scene), ElementsAre("loads[0].edge_traction.edge"));
}

TEST(HostileScene, WithMoreMistakesThanAnybodyReadsHasItsViolationsCut) {
  Scene scene = sample_scene();
  scene.loads[0].time = Table{std::vector<double>(1'000'000, not_a_number), std::vector<double>(1'000'000, 0)};
  EXPECT_EQ(violations_of(scene).size(), 1000u);
}

TEST(HostileScene, WithTooManyEntriesIsRefusedByCounting) {
  Scene scene = sample_scene();
  scene.constants.resize(1'000'000);
  scene.materials.resize(1'000'000);
  scene.boundaries.resize(1'000'000);
  scene.loads.resize(1'000'000);
  scene.outputs.probes.resize(1'000'000);
  scene.measures.resize(1'000'000);
  EXPECT_THAT(paths_of(scene), testing::IsSupersetOf({"constants", "materials", "boundaries", "loads",
                                                      "outputs.probes", "measures"}));
}

TEST(HostileScene, WithTooManyLongFormulasIsRefusedByCounting) {
  Scene scene = sample_scene();
  std::string formula = "1";
  while (formula.size() < 1000) formula += "*1";
  for (int i = 0; i < 900; ++i) scene.constants.push_back({std::string("k").append(std::to_string(i)), formula});
  EXPECT_THAT(paths_of(scene), Contains("constants[903].value"));
}

TEST(HostileScene, WithVeryLongTextsHasShortViolations) {
  Scene scene = sample_scene();
  const std::string text(10'000'000, 'a');
  scene.name = scene.bodies[0].name = scene.bodies[0].material = scene.numerics.scheme = text;
  scene.measures[0].quantity = scene.measures[0].exact = scene.constants[0].value = text;
  for (const Violation& violation : violations_of(scene)) {
    EXPECT_LT(violation.path.size() + violation.value.size() + violation.problem.size() + violation.remedy.size(),
              4000u)
        << violation.path;
  }
}

}  // namespace
}  // namespace trajan
