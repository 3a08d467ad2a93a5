#include <gtest/gtest.h>

#include "tests/unit/simulation/scenes.h"

/// Bodies that come apart though nothing in the scene breaks them.
namespace trajan {
namespace {

/// Two soft blocks, each of which is torn by a velocity that grows along it; the second is drawn away from the
/// first.
Scene torn(const std::string& law, const std::string& scheme, double rate) {
  Scene scene;
  scene.name = "torn";
  scene.domain = {Dimension::plane_strain, {-20, -2}, {40, 2}, 0.5, 1};
  scene.materials = {test::material(law, 1e-3, 0.3, 1)};
  const std::string along = std::to_string(rate);
  scene.bodies = {{"one", "solid", Box{{-1, 0}, {1, 1}}, 2, {along + "*x", {}}},
                  {"two", "solid", Box{{3, 0}, {5, 1}}, 2, {"5+" + along + "*(x-4)", {}}}};
  scene.analysis = {2, 0};
  scene.numerics.scheme = scheme;
  scene.numerics.time_step = 0.01;
  scene.outputs.samples = 20;
  scene.outputs.snapshots = 1;
  return scene;
}

RunResult result_of(const Scene& scene) {
  test::Memory memory;
  return run(validate(scene), {}, memory, nullptr);
}

TEST(Coherence, OfABodyThatIsTornIsLostWithAWarning) {
  for (const char* law : {"linear_elastic", "neo_hookean"}) {
    const RunResult result = result_of(torn(law, "MUSL", 3));
    ASSERT_EQ(result.end, RunEnd::finished) << (result.divergence ? result.divergence->cause : "");
    ASSERT_TRUE(result.warning) << law;
    // Particles are a quarter apart at rest, and three cells hold none of them between two that the tear has
    // parted.
    EXPECT_NE(result.warning->cause.find("\"one\""), std::string::npos) << result.warning->cause;
    EXPECT_GT(result.warning->step, 0);
    EXPECT_GT(result.warning->time, 0);
    EXPECT_LT(result.warning->particle, 8 * 4);
    EXPECT_FALSE(result.warning->remedy.empty());
  }
}

TEST(Coherence, OfBodiesThatPartIsKept) {
  for (const char* law : {"linear_elastic", "neo_hookean"})
    for (const char* shape : {"linear", "quadratic_bspline"}) {
      Scene scene = torn(law, "MUSL", 0);
      scene.numerics.shape_functions = shape;
      EXPECT_FALSE(result_of(scene).warning) << law << " " << shape;
    }
}

TEST(Coherence, IsNotAskedOfFluidsNorOfReferenceCells) {
  Scene splash = torn("linear_elastic", "MUSL", 3);
  splash.materials = {{"solid", 1, "tait_fluid", {{"bulk_modulus", 1e-3}}}};
  EXPECT_FALSE(result_of(splash).warning);
  EXPECT_FALSE(result_of(torn("neo_hookean", "TLMPM", 3)).warning);
}

}  // namespace
}  // namespace trajan
