#include "tests/unit/server/every_field.h"

namespace trajan {
namespace {

using ::testing::ElementsAre;

TEST_F(EveryField, KeepsBoundaries) {
  ASSERT_EQ(scene_.boundaries.size(), 12u);
  EXPECT_EQ(scene_.boundaries[0].name, "clamp");
  expect_box(std::get<Region>(scene_.boundaries[0].nodes), 7.1, 7.2, 7.3, 7.4);
  EXPECT_THAT(std::get<Fixed>(scene_.boundaries[0].condition).axes,
              ElementsAre(Axis::y, Axis::x, Axis::z, Axis::unspecified));
  expect_disc(std::get<Region>(scene_.boundaries[1].nodes), 8.1, 8.2, 8.3);
  const auto& piston = std::get<PrescribedVelocity>(scene_.boundaries[1].condition);
  EXPECT_EQ(piston.velocity.x, "3*t");
  EXPECT_EQ(piston.velocity.y, "4*t");
  EXPECT_EQ(piston.velocity.z, "5*t");
}

TEST_F(EveryField, KeepsBoundariesOnFaces) {
  EXPECT_EQ(std::get<Edge>(scene_.boundaries[2].nodes), Edge::left);
  EXPECT_EQ(std::get<Roller>(scene_.boundaries[2].condition).normal, Axis::z);
  EXPECT_EQ(scene_.boundaries[3].nodes.index(), 0u);
  EXPECT_EQ(std::get<Symmetry>(scene_.boundaries[3].condition).face, Edge::right);
  EXPECT_EQ(std::get<PrescribedDisplacement>(scene_.boundaries[4].condition).displacement.x, "31*t");
}

TEST_F(EveryField, KeepsRigidObstacles) {
  const auto& floor = std::get<RigidPlane>(scene_.boundaries[5].condition);
  expect_vector(floor.point, 32.1, 0);
  expect_vector(floor.normal, 0, 32.2);
  EXPECT_EQ(floor.contact.friction, 32.3);
  EXPECT_TRUE(floor.contact.bonded);
  EXPECT_TRUE(floor.contact.no_separation);
  EXPECT_EQ(floor.contact.displacement.y, "32*t");
  const auto& ball = std::get<RigidBall>(scene_.boundaries[6].condition);
  expect_vector(ball.centre, 33.1, 0);
  EXPECT_EQ(ball.radius, 33.2);
  EXPECT_EQ(ball.contact.friction, 33.3);
  EXPECT_FALSE(ball.contact.bonded || ball.contact.no_separation);
}

TEST_F(EveryField, KeepsConditionsOnSurfaces) {
  const auto& pin = std::get<Hinge>(scene_.boundaries[7].condition);
  EXPECT_EQ(pin.surface.body, "beam");
  EXPECT_EQ(std::get<Edge>(pin.surface.part), Edge::bottom);
  expect_disc(pin.surface.within, 34.1, 0, 34.2);
  EXPECT_EQ(pin.kind, HingeKind::mean);
  EXPECT_THAT(pin.axes, ElementsAre(Axis::y));
  EXPECT_EQ(pin.displacement.x, "34*t");
  EXPECT_EQ(std::get<Hinge>(scene_.boundaries[8].condition).kind, HingeKind::whole);
  EXPECT_EQ(std::get<Edge>(std::get<Hinge>(scene_.boundaries[8].condition).surface.part), Edge::front);
  EXPECT_EQ(std::get<Hinge>(scene_.boundaries[9].condition).kind, HingeKind::unspecified);
  const auto& quiet = std::get<Absorbing>(scene_.boundaries[10].condition);
  EXPECT_EQ(std::get<Disc>(quiet.surface.part).radius, 35.2);
  EXPECT_EQ(std::get<Periodic>(scene_.boundaries[11].condition).axis, Axis::z);
}

TEST_F(EveryField, KeepsPressures) {
  const auto& blown = std::get<Pressure>(scene_.loads[6].kind);
  EXPECT_EQ(std::get<Edge>(blown.surface.part), Edge::back);
  EXPECT_EQ(blown.pressure, 36.1);
  EXPECT_EQ(blown.profile, "36*x");
  EXPECT_FALSE(blown.follows);
  EXPECT_TRUE(std::get<Pressure>(scene_.loads[7].kind).follows);
  EXPECT_EQ(std::get<Disc>(std::get<EdgeTraction>(scene_.loads[1].kind).within).radius, 37.1);
}

TEST_F(EveryField, KeepsLoads) {
  ASSERT_EQ(scene_.loads.size(), 9u);
  EXPECT_EQ(scene_.loads[0].name, "point");
  const auto& point = std::get<PointForce>(scene_.loads[0].kind);
  EXPECT_EQ(point.body, "ball");
  expect_vector(point.position, 9.1, 9.2);
  expect_vector(point.force, 9.3, 9.4);
  const auto& left = std::get<EdgeTraction>(scene_.loads[1].kind);
  EXPECT_EQ(left.body, "beam");
  expect_vector(left.traction, 10.1, 10.2);
  EXPECT_EQ(left.profile, "y");
  std::vector<Edge> edges;
  for (int i : {1, 2, 3, 4}) edges.push_back(std::get<EdgeTraction>(scene_.loads[i].kind).edge);
  EXPECT_THAT(edges, ElementsAre(Edge::left, Edge::right, Edge::bottom, Edge::top));
  const auto& gravity = std::get<BodyForce>(scene_.loads[5].kind);
  EXPECT_FALSE(gravity.reference);
  const auto& source = std::get<BodyForce>(scene_.loads.back().kind);
  EXPECT_EQ(source.field.x, "8*x");
  EXPECT_EQ(source.field.y, "8*y");
  EXPECT_EQ(source.field.z, "8*z");
  EXPECT_TRUE(source.reference);
  expect_vector(gravity.acceleration, 13.1, 13.2);
  EXPECT_THAT(gravity.bodies, ElementsAre("ball", "beam"));
}

}  // namespace
}  // namespace trajan
