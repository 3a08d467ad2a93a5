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
    // Particles are a quarter apart at rest, and three cells hold none of them between two that the tear has
    // parted. Both bodies are torn.
    ASSERT_EQ(result.warnings.size(), 2u) << law;
    for (std::size_t b = 0; b < 2; ++b) {
      const Warning& warning = result.warnings[b];
      EXPECT_EQ(warning.name, b == 0 ? "coherence of \"one\"" : "coherence of \"two\"");
      EXPECT_GT(warning.step, 0);
      EXPECT_GT(warning.time, 0);
      EXPECT_EQ(warning.particle / (8 * 4), b);
      EXPECT_FALSE(warning.remedy.empty());
    }
  }
}

TEST(Coherence, OfBodiesThatPartIsKept) {
  for (const char* law : {"linear_elastic", "neo_hookean"})
    for (const char* shape : {"linear", "quadratic_bspline"}) {
      Scene scene = torn(law, "MUSL", 0);
      scene.numerics.shape_functions = shape;
      EXPECT_TRUE(result_of(scene).warnings.empty()) << law << " " << shape;
    }
}

TEST(Coherence, IsNotAskedOfFluidsNorOfReferenceCells) {
  Scene splash = torn("linear_elastic", "MUSL", 3);
  splash.materials = {{"solid", 1, "tait_fluid", {{"bulk_modulus", 1e-3}}}};
  EXPECT_TRUE(result_of(splash).warnings.empty());
  EXPECT_TRUE(result_of(torn("neo_hookean", "TLMPM", 3)).warnings.empty());
}

}  // namespace
}  // namespace trajan
