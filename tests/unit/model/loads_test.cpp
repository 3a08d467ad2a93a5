#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/model/sample_scene.h"

namespace trajan {
namespace {

struct Resultant {
  double x = 0, y = 0;
  double moment = 0;  ///< about the origin
};

Resultant resultant_of(const SurfaceLoad& load) {
  Resultant sum;
  for (const LoadPoint& point : load.points) {
    sum.x += point.force.x;
    sum.y += point.force.y;
    sum.moment += point.position.x * point.force.y - point.position.y * point.force.x;
  }
  return sum;
}

/// A beam (0, 0) to (3, 1) of thickness 0.5 whose particles do not line up with the grid.
Model beam_under(Edge edge, Vector traction, const std::string& profile, double cell = 0.3) {
  Scene scene = sample_scene();
  scene.domain.cell_size = cell;
  scene.domain.thickness = 0.5;
  scene.bodies = {{"beam", "rubber", Box{{0, 0}, {3, 1}}, 2, {}}};
  scene.boundaries.clear();
  scene.loads.resize(1);
  scene.loads[0].kind = EdgeTraction{"beam", edge, traction, profile};
  return validate(scene);
}

/// Sums of about a hundred numbers of size 1.
constexpr double rounding = 1e-13;

TEST(EdgeTraction, HasTheResultantAndMomentOfTheTraction) {
  const double thickness = 0.5;
  const Resultant right = resultant_of(beam_under(Edge::right, {2, -3}, "").surface_loads[0]);
  EXPECT_NEAR(right.x, 2 * thickness, rounding);
  EXPECT_NEAR(right.y, -3 * thickness, rounding);
  EXPECT_NEAR(right.moment, (3 * -3 - 0.5 * 2) * thickness, rounding);
  const Resultant top = resultant_of(beam_under(Edge::top, {2, -3}, "").surface_loads[0]);
  EXPECT_NEAR(top.x, 3 * 2 * thickness, rounding);
  EXPECT_NEAR(top.y, 3 * -3 * thickness, rounding);
  EXPECT_NEAR(top.moment, (1.5 * -9 - 1 * 6) * thickness, rounding);
}

/// A panel with upright ends and slanted sides.
Scene panel(LoadDefinition load) {
  Scene scene = sample_scene();
  scene.domain.cell_size = 0.3;
  scene.domain.thickness = 0.5;
  scene.bodies = {{"beam", "rubber", Polygon{{{0, 0}, {3, 0.5}, {3, 1.6}, {0, 1}}}, 2, {}}};
  scene.boundaries.clear();
  scene.loads = {std::move(load)};
  return scene;
}

TEST(EdgeTraction, ActsOnTheSidesOfAPolygonThatLieAlongTheAxes) {
  const Scene scene = panel({"load", EdgeTraction{"beam", Edge::right, {2, -3}, ""}, {}});
  const Resultant right = resultant_of(validate(scene).surface_loads[0]);
  EXPECT_NEAR(right.x, 2 * 1.1 * 0.5, rounding);
  EXPECT_NEAR(right.y, -3 * 1.1 * 0.5, rounding);
  EXPECT_NEAR(right.moment, (3 * -3 - 1.05 * 2) * 1.1 * 0.5, rounding);
  for (const auto& [edge, sign] : {std::pair{Edge::right, -1}, std::pair{Edge::left, 1}}) {
    Pressure pressure;
    pressure.surface = {"beam", edge, {}};
    pressure.pressure = 2;
    const Resultant pushed = resultant_of(validate(panel({"load", pressure, {}})).surface_loads[0]);
    EXPECT_NEAR(pushed.x, sign * 2 * (edge == Edge::right ? 1.1 : 1) * 0.5, rounding);
    EXPECT_NEAR(pushed.y, 0, rounding);
  }
}

TEST(EdgeTraction, IsRefusedWhereAPolygonHasNoSuchSide) {
  try {
    validate(panel({"load", EdgeTraction{"beam", Edge::top, {2, -3}, ""}, {}}));
    FAIL();
  } catch (const InvalidScene& error) {
    ASSERT_EQ(error.violations().size(), 1u);
    EXPECT_EQ(error.violations()[0].path, "loads[0].edge_traction.edge");
    EXPECT_NE(error.violations()[0].problem.find("no side of the polygon"), std::string::npos);
  }
}

TEST(EdgeTraction, IsExactForTheShearAndBendingStressesOfBeams) {
  const double thickness = 0.5;
  const Resultant shear = resultant_of(beam_under(Edge::right, {0, -1}, "6 * y * (1 - y)").surface_loads[0]);
  EXPECT_NEAR(shear.y, -thickness, rounding);
  EXPECT_NEAR(shear.moment, -3 * thickness, rounding);
  const Resultant bending = resultant_of(beam_under(Edge::left, {12, 0}, "0.5 - y").surface_loads[0]);
  EXPECT_NEAR(bending.x, 0, rounding);
  // Integral of -y * 12 * (1/2 - y) over the height.
  EXPECT_NEAR(bending.moment, thickness, rounding);
}

TEST(EdgeTraction, IsOfFourthOrderForOtherProfiles) {
  const double exact = 0.5 * (1 - std::cos(3.0)) / 3;
  const auto error = [&](double cell) {
    return std::abs(resultant_of(beam_under(Edge::right, {0, 1}, "sin(3 * y)", cell).surface_loads[0]).y - exact);
  };
  // 4 and 8 particles along the edge; the next term of the error changes the order by a few percent.
  EXPECT_NEAR(std::log2(error(0.5) / error(0.25)), 4, 0.1);
}

TEST(EdgeTraction, ActsOnTheEdgeThroughTheOutermostParticles) {
  for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top}) {
    const Model model = beam_under(edge, {1, 1}, "");
    const Lattice& lattice = model.bodies[0].lattice;
    const bool vertical = edge == Edge::left || edge == Edge::right;
    const double level = edge == Edge::right ? 3 : edge == Edge::top ? 1 : 0;
    EXPECT_EQ(model.surface_loads[0].points.size(),
              2u * static_cast<unsigned>(vertical ? lattice.rows : lattice.columns));
    for (const LoadPoint& point : model.surface_loads[0].points) {
      EXPECT_EQ(vertical ? point.position.x : point.position.y, level);
      const Vector carrier = lattice.point(point.carrier % lattice.columns, point.carrier / lattice.columns);
      EXPECT_LE(std::abs(point.position.x - carrier.x), lattice.spacing.x / 2 * (1 + 1e-9));
      EXPECT_LE(std::abs(point.position.y - carrier.y), lattice.spacing.y / 2 * (1 + 1e-9));
    }
  }
}

TEST(PointForce, ActsWhereItWasAskedThroughTheNearestParticle) {
  const Model model = validate(sample_scene());
  ASSERT_EQ(model.surface_loads.size(), 2u);
  ASSERT_EQ(model.surface_loads[1].points.size(), 1u);
  const LoadPoint& point = model.surface_loads[1].points[0];
  EXPECT_EQ(point.position.x, 8);
  EXPECT_EQ(point.position.y, 0.5);
  EXPECT_EQ(point.force.x, 1);
  EXPECT_EQ(point.carrier, 64 * 3 + 63);
  EXPECT_DOUBLE_EQ(model.surface_loads[1].time(2), std::exp(-2));
}

TEST(BodyForce, ActsOnAllBodiesUnlessSomeAreNamed) {
  Scene scene = sample_scene();
  EXPECT_EQ(validate(scene).body_loads.at(0).bodies, std::vector<std::size_t>{0});
  std::get<BodyForce>(scene.loads[1].kind).bodies.clear();
  EXPECT_EQ(validate(scene).body_loads.at(0).bodies, (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace trajan
