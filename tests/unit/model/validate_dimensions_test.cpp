#include "tests/unit/model/mistake.h"

namespace trajan {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene scene_of(Dimension dimension, Vector lower, Vector upper, Region body) {
  Scene scene;
  scene.name = "small";
  scene.domain = {dimension, lower, upper, 0.25};
  scene.materials = {{"rubber", 2, "neo_hookean", {{"youngs_modulus", 3000}, {"poissons_ratio", 0.3}}}};
  scene.bodies = {{"body", "rubber", std::move(body), 2, {}}};
  scene.analysis = {1, 0};
  return scene;
}

Scene bar() { return scene_of(Dimension::bar, {0}, {4}, Box{{1}, {3}}); }
Scene solid() { return scene_of(Dimension::solid, {0, 0, 0}, {4, 4, 4}, Sphere{{2, 2, 2}, 1}); }
Scene axisymmetric() { return scene_of(Dimension::axisymmetric, {0, 0}, {4, 4}, Box{{0, 1}, {2, 3}}); }

TEST(Dimensions, AllAreRight) {
  EXPECT_THAT(paths_of(bar()), IsEmpty());
  EXPECT_THAT(paths_of(solid()), IsEmpty());
  EXPECT_THAT(paths_of(axisymmetric()), IsEmpty());
}

TEST(Dimensions, HaveTheVolumesOfTheirBodies) {
  Scene scene = bar();
  scene.domain.cross_section = 0.5;
  const Model rod = validate(scene);
  EXPECT_EQ(rod.grid.cells_y, 0);
  EXPECT_EQ(rod.bodies[0].particles, 16);
  EXPECT_DOUBLE_EQ(rod.bodies[0].particle_volume, 0.125 * 0.5);
  const Model ball = validate(solid());
  EXPECT_EQ(ball.grid.cells_z, 16);
  EXPECT_DOUBLE_EQ(ball.bodies[0].particle_volume, 0.125 * 0.125 * 0.125);
  EXPECT_DOUBLE_EQ(validate(axisymmetric()).bodies[0].particle_volume, 0.125 * 0.125) << "an area";
}

TEST(Dimensions, RefuseWhatTheyDoNotHave) {
  Scene scene = bar();
  scene.domain.thickness = 2;
  scene.domain.upper.y = 1;
  scene.bodies[0].geometry = Box{{1, 0, 0.5}, {3}};
  scene.bodies[0].initial_velocity = {"x", "1", std::nullopt};
  scene.boundaries = {{"end", Region{Box{{0}, {0}}}, Fixed{{Axis::y}}},
                      {"other", Region{Box{{4}, {4}}}, PrescribedVelocity{{"t", std::nullopt, "t"}}}};
  LoadDefinition gravity;
  gravity.name = "gravity";
  gravity.kind = BodyForce{{0, -9.81}, {}};
  scene.loads = {gravity};
  EXPECT_THAT(paths_of(scene),
              ElementsAre("domain.upper.y", "domain.thickness", "bodies[0].geometry.box.lower.z",
                          "bodies[0].initial_velocity.y", "boundaries[0].fixed.axes[0]",
                          "boundaries[1].prescribed_velocity.velocity.z", "loads[0].body_force.acceleration.y"));
}

TEST(Dimensions, RefuseShapesOfOthers) {
  Scene scene = solid();
  scene.bodies[0].geometry = Disc{{2, 2}, 1};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].geometry.disc"));
  EXPECT_THAT(violations_of(scene)[0].remedy, HasSubstr("sphere"));
  scene = axisymmetric();
  scene.bodies[0].geometry = Sphere{{1, 1}, 1};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].geometry.sphere"));
  scene = bar();
  scene.bodies[0].geometry = Polygon{{{1}, {2}, {3}}};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].geometry.polygon"));
}

TEST(Dimensions, FormulasMayUseTheirOwnCoordinates) {
  Scene scene = bar();
  scene.bodies[0].initial_velocity.x = "y";
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].initial_velocity.x"));
  scene = solid();
  scene.bodies[0].initial_velocity.z = "x + y + z";
  EXPECT_THAT(paths_of(scene), IsEmpty());
}

TEST(Dimensions, AxisymmetricRadiusIsNotNegative) {
  Scene scene = axisymmetric();
  scene.domain.lower.x = -1;
  EXPECT_THAT(paths_of(scene), ElementsAre("domain.lower.x"));
}

class RegionMistake : public testing::TestWithParam<Mistake> {};

TEST_P(RegionMistake, GivesItsOneViolation) {
  const Mistake& mistake = GetParam();
  Scene scene = solid();
  mistake.make(scene);
  ASSERT_THAT(paths_of(scene), ElementsAre(mistake.path));
  EXPECT_THAT(violations_of(scene)[0].problem, HasSubstr(mistake.problem));
}

const Sphere ball = {{2, 2, 2}, 1};

const std::vector<Mistake> regions = {
    {"NoRadius",
     [](Scene& s) {
       s.bodies[0].geometry = Sphere{{2, 2, 2}, 0};
     },
     "bodies[0].geometry.sphere.radius", "greater than 0"},
    {"NoLength",
     [](Scene& s) {
       s.bodies[0].geometry = Cylinder{{2, 2, 2}, {2, 2, 2}, 1};
     },
     "bodies[0].geometry.cylinder.to", "no length"},
    {"NoContent", [](Scene& s) { s.bodies[0].geometry = Mesh{}; }, "bodies[0].geometry.mesh.stl", "no content"},
    {"BadContent", [](Scene& s) { s.bodies[0].geometry = Mesh{"solid cow moo"}; }, "bodies[0].geometry.mesh.stl",
     "no triangle"},
    {"EmptyUnion", [](Scene& s) { s.bodies[0].geometry = Union{}; }, "bodies[0].geometry.union", "too few"},
    {"DifferenceOfOne", [](Scene& s) { s.bodies[0].geometry = Difference{{{ball}}}; },
     "bodies[0].geometry.difference", "too few"},
    {"PartWithoutAShape",
     [](Scene& s) {
       s.bodies[0].geometry = Difference{{{ball}, {Region{}}}};
     },
     "bodies[0].geometry.difference.regions[1]", "no shape"},
    {"NothingIsLeft",
     [](Scene& s) {
       s.bodies[0].geometry = Difference{{{ball}, {Box{{0, 0, 0}, {4, 4, 4}}}}};
     },
     "bodies[0].geometry", "no particle"},
    {"PartsApart",
     [](Scene& s) {
       s.bodies[0].geometry = Intersection{{{Box{{0, 0, 0}, {1, 1, 1}}}, {Box{{2, 2, 2}, {3, 3, 3}}}}};
     },
     "bodies[0].geometry", "no particle"},
    {"NestedTooDeeply",
     [](Scene& s) {
       Region region = ball;
       for (int i = 0; i < 30; ++i) region = Union{{{region}}};
       s.bodies[0].geometry = region;
     },
     "bodies[0].geometry" +
         [] {
           std::string path;
           for (int i = 0; i < 20; ++i) path += ".union.regions[0]";
           return path;
         }() +
         ".union",
     "too deeply"},
    {"TooManyRegions", [](Scene& s) { s.bodies[0].geometry = Union{std::vector<Part>(10'001, Part{ball})}; },
     "bodies[0].geometry.union", "too many regions"},
    {"TooMuchWork",
     [](Scene& s) {
       s.domain = {Dimension::solid, {0, 0, 0}, {4, 1e5, 1e5}, 0.25};
       s.bodies[0].geometry = Union{{{Box{{0, 0, 0}, {1, 1, 1}}}, {Box{{1, 1e5 - 1, 1e5 - 1}, {2, 1e5, 1e5}}}}};
     },
     "bodies[0]", "too many particles"},
};

INSTANTIATE_TEST_SUITE_P(Regions, RegionMistake, testing::ValuesIn(regions), name_of);

TEST(InitialState, BelongsToTheKindOfTheLaw) {
  Scene scene = solid();
  scene.bodies[0].initial_stress.components[3] = "x";
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].initial_stress"));
  scene.materials[0].law = "linear_elastic";
  EXPECT_THAT(paths_of(scene), IsEmpty());
  scene.bodies[0].initial_deformation.components[0] = "2";
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].initial_deformation"));
}

TEST(InitialState, HasNoComponentsThatTheDimensionDetermines) {
  Scene scene = sample_scene();
  scene.bodies[0].initial_stress.components = {"1", "1", "1", "1", "1", "1"};
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].initial_stress.zz", "bodies[0].initial_stress.yz",
                                           "bodies[0].initial_stress.xz"));
  scene.domain.dimension = Dimension::plane_strain;
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].initial_stress.yz", "bodies[0].initial_stress.xz"));
}

TEST(InitialState, DeformedBodyHasTheMassOfTheStressFreeOne) {
  Scene scene = solid();
  scene.bodies[0].initial_deformation.components[0] = "2";
  scene.bodies[0].initial_deformation.components[1] = "0.1 * x";
  EXPECT_DOUBLE_EQ(validate(scene).bodies[0].particle_volume, 0.125 * 0.125 * 0.125 / 2);
  scene.bodies[0].initial_deformation.components[3] = "0.1";
  EXPECT_THAT(paths_of(scene), ElementsAre("bodies[0].initial_deformation"));
  EXPECT_THAT(violations_of(scene)[0].problem, HasSubstr("not uniform"));
  scene.bodies[0].initial_deformation.components[0] = "-2";
  EXPECT_THAT(violations_of(scene)[0].problem, HasSubstr("determinant is -"));
}

TEST(BodyForce, MayBeGivenByFormulas) {
  Scene scene = solid();
  LoadDefinition source;
  source.name = "source";
  source.kind = BodyForce{{}, {}, {"t * z", std::nullopt, "x"}, true};
  scene.loads = {source};
  const Model model = validate(scene);
  EXPECT_EQ((*model.body_loads[0].field[0])({0, 0, 3}, 2), 6);
  EXPECT_FALSE(model.body_loads[0].field[1]);
  EXPECT_TRUE(model.body_loads[0].reference);
  std::get<BodyForce>(scene.loads[0].kind).acceleration.x = 1;
  EXPECT_THAT(paths_of(scene), ElementsAre("loads[0].body_force.field"));
}

TEST(Combinations, ThatMakeNoSenseAreRefusedWithTheirReason) {
  Scene scene = sample_scene();
  scene.numerics.transfer_order = 2;
  EXPECT_THAT(paths_of(scene), ElementsAre("numerics.transfer_order"));
  scene.numerics = {};
  scene.numerics.transfer = "APCI";
  EXPECT_THAT(paths_of(scene), ElementsAre("numerics.transfer"));
  scene.numerics = {};
  scene.numerics.shape_functions = "bernstein";
  EXPECT_THAT(paths_of(scene), Contains("numerics.shape_functions"));
}

}  // namespace
}  // namespace trajan
