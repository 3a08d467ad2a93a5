#include "tests/unit/model/mistake.h"

namespace trajan {
namespace {

using testing::ElementsAre;

/// The sample scene in equilibrium, its beam's particles at Gauss' points.
Scene with_gauss_points(Scene scene) {
  scene.analysis.kind = QuasiStatic{};
  scene.analysis.damping = 0;
  scene.bodies[1].initial_velocity = {};
  scene.numerics.scheme = "TLMPM";
  scene.bodies[0].particle_layout = ParticleLayout::gauss;
  return scene;
}

TEST(ParticleLayouts, MayHaveParticlesAtGaussPoints) {
  const Scene scene = with_gauss_points(sample_scene());
  EXPECT_THAT(paths_of(scene), ElementsAre());
  const Model model = validate(scene);
  EXPECT_FALSE(model.bodies[0].lattice.shares.empty());
  EXPECT_TRUE(model.bodies[1].lattice.shares.empty());
}

class ParticleLayoutMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ParticleLayoutMistake, GivesItsOneViolation) { expect_violation(GetParam()); }

const std::vector<Mistake> mistakes = {
    {"UnknownLayout", [](Scene& s) { s.bodies[1].particle_layout = ParticleLayout::unspecified; },
     "bodies[1].particle_layout", "no such layout"},
    {"GaussPointsInADisc",
     [](Scene& s) {
       s = with_gauss_points(s);
       s.bodies[1].particle_layout = ParticleLayout::gauss;
     },
     "bodies[1].particle_layout", "only a box"},
    {"GaussPointsInABoxThatCutsCells",
     [](Scene& s) {
       s = with_gauss_points(s);
       s.bodies[0].geometry = Box{{0, 0}, {8, 1.1}};
     },
     "bodies[0].particle_layout", "along y the box cuts cells"},
    {"GaussPointsInExplicitSteps",
     [](Scene& s) {
       s.numerics.scheme = "TLMPM";
       s.bodies[0].particle_layout = ParticleLayout::gauss;
     },
     "bodies[0].particle_layout", "equally heavy"},
    {"GaussPointsThatMove",
     [](Scene& s) {
       s = with_gauss_points(s);
       s.numerics.scheme = "MUSL";
     },
     "bodies[0].particle_layout", "leave the places", "TLMPM"},
    {"GaussPointsOfHalfACell",
     [](Scene& s) {
       s = with_gauss_points(s);
       s.numerics.shape_functions = "quadratic_bspline";
       s.bodies[0].particles_per_cell_side = 3;
     },
     "bodies[0].particle_layout", "halves", "even number"},
    {"GaussPointsOfBoxes",
     [](Scene& s) {
       s = with_gauss_points(s);
       s.numerics.shape_functions = "gimp";
     },
     "bodies[0].particle_layout", "boxes of one size"},
};

INSTANTIATE_TEST_SUITE_P(, ParticleLayoutMistake, testing::ValuesIn(mistakes), name_of);

}  // namespace
}  // namespace trajan
