#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/implicit/statics.h"

/// What boundary conditions bear of the loads.
namespace trajan {
namespace {

using namespace test;

/// The force of a boundary condition along an axis, in a row.
double reaction(const Model& model, const Answer& answer, std::size_t row, const std::string& name) {
  return answer.memory.rows.at(row)[column(model, "reactions." + name)];
}

Scene loaded(const std::string& scheme, const std::string& shapes) {
  Scene scene = block(Dimension::plane_strain, "neo_hookean", 2, 0.25, 0.3);
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{}}, {"aside", Box{{4, 2}, {5, 3}}, Fixed{}}};
  scene.numerics.scheme = scheme;
  scene.numerics.shape_functions = shapes;
  scene.loads = {growing(traction("block", Edge::right, {3, -2})), {"weight", BodyForce{{0, -0.5}, {}}, "t"}};
  scene.outputs.reactions = {"aside", "left"};
  return scene;
}

class StaticReactions : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

// A height of 1 under the traction, a mass of 2. Newton's tolerance is 1e-8 of the forces on single nodes.
TEST_P(StaticReactions, BearTheLoadsOfTheSample) {
  const auto& [scheme, shapes] = GetParam();
  const Model model = validate(loaded(scheme, shapes));
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  for (std::size_t row : {1u, 2u}) {
    const double factor = 0.5 * static_cast<double>(row);
    EXPECT_NEAR(reaction(model, answer, row, "left.x"), -3 * factor, 1e-5);
    EXPECT_NEAR(reaction(model, answer, row, "left.y"), 3 * factor, 1e-5);
    EXPECT_EQ(reaction(model, answer, row, "aside.y"), 0) << "where there is no material";
  }
  EXPECT_EQ(reaction(model, answer, 0, "left.x"), 0);
}
INSTANTIATE_TEST_SUITE_P(, StaticReactions,
                         ::testing::Values(std::tuple{"TLMPM", "linear"}, std::tuple{"MUSL", "gimp"},
                                           std::tuple{"TLMPM", "cubic_bspline"}));

/// Stencils of splines that keep their degree are moved into the domain: wherever its faces are among the tiles,
/// loads there must find the nodes.
TEST(Reactions, BearLoadsOnFacesOfTheDomain) {
  for (const std::string shapes : {"quadratic_bspline", "cubic_bspline"})
    for (const int cells : {8, 9, 10, 12})
      for (const bool upper : {false, true}) {
        const double length = 0.25 * cells;
        Scene scene = block(Dimension::plane_strain, "neo_hookean", length, 0.25, 0.3);
        scene.numerics.shape_functions = shapes;
        scene.domain.lower = {0, -1}, scene.domain.upper = {length, 3};
        const double held = upper ? 0 : length;
        scene.boundaries = {{"end", Box{{held, -1}, {held, 3}}, Fixed{}}};
        scene.loads = {growing(traction("block", upper ? Edge::right : Edge::left, {1, -0.5}))};
        scene.outputs.reactions = {"end"};
        const Model model = validate(scene);
        const Answer answer = solve(model);
        ASSERT_EQ(answer.result.end, RunEnd::finished) << shapes << ' ' << cells << ' ' << upper;
        EXPECT_NEAR(reaction(model, answer, 2, "end.x"), -1, 1e-5) << shapes << ' ' << cells << ' ' << upper;
        EXPECT_NEAR(reaction(model, answer, 2, "end.y"), 0.5, 1e-5) << shapes << ' ' << cells << ' ' << upper;
      }
}

TEST(Reactions, OfAHingeAndOfNodesShareTheLoad) {
  Scene scene = block(Dimension::plane_strain, "linear_strain_elastic", 2, 0.25, 0);
  Hinge hinge;
  hinge.surface = {"block", Edge::right, {}};
  hinge.kind = HingeKind::mean;
  hinge.axes = {Axis::y};
  scene.boundaries = {{"left", Box{{-1, -1}, {0, 3}}, Fixed{}}, {"hinge", {}, hinge}};
  scene.loads = {{"weight", BodyForce{{0, -1}, {}}, "t"}};
  scene.outputs.reactions = {"left", "hinge"};
  const Model model = validate(scene);
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  const double at_hinge = reaction(model, answer, 2, "hinge.y"), at_wall = reaction(model, answer, 2, "left.y");
  EXPECT_NEAR(at_wall + at_hinge, 2, 1e-6);
  // Of a propped cantilever 3/8 of the load by Bernoulli, less by what shear takes: a quarter of this length.
  EXPECT_GT(at_hinge, 0.3 * 2);
  EXPECT_LT(at_hinge, 0.5 * 2);
  EXPECT_EQ(reaction(model, answer, 2, "hinge.x"), 0);
}

TEST(Reactions, OfImplicitDynamicsSayHowTheMomentumChanges) {
  Scene scene = loaded("TLMPM", "linear");
  ImplicitDynamics analysis;
  analysis.method = Newmark{};
  analysis.time_steps = 20;
  analysis.newton.tolerance = 1e-12;
  scene.analysis = {1, 0, analysis};
  scene.loads = {{"weight", BodyForce{{0.3, -0.5}, {}}, 1.0}};
  scene.outputs.samples = 4;
  scene.bodies[0].initial_velocity.y = "-0.1*x";
  const Model model = validate(scene);
  const Answer answer = solve(model);
  ASSERT_EQ(answer.result.end, RunEnd::finished);
  for (const char* axis : {"x", "y"}) {
    const std::string momentum = std::string("momentum.") + axis, left = std::string("left.") + axis;
    const double weight = axis == std::string("x") ? 0.6 : -1;
    for (std::size_t row = 1; row <= 4; ++row) {
      const double change =
          answer.memory.rows[row][column(model, momentum)] - answer.memory.rows[row - 1][column(model, momentum)];
      // Newton's tolerance, 1e-12 of the forces.
      EXPECT_NEAR(change, 0.25 * (weight + reaction(model, answer, row, left)), 1e-10) << axis << row;
    }
  }
}

}  // namespace
}  // namespace trajan
