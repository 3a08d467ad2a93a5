#include "solver/contact/meeting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/contact/body_surface.h"
#include "tests/unit/simulation/scenes.h"

/// What bodies know of their own surfaces, and what nodes see of two of them.
namespace trajan {
namespace {

using std::numbers::pi;

/// A body alone, in cells of 1.
Model model_of(const Region& geometry) {
  Scene scene;
  scene.name = "surface";
  scene.domain = {Dimension::plane_strain, {-30, -30}, {30, 30}, 1, 1};
  scene.materials = {test::material("neo_hookean", 1000, 0.3, 1)};
  scene.bodies = {{"body", "solid", geometry, 2, {}}};
  scene.analysis.end_time = 1;
  return validate(scene);
}

/// Calls of(place, normal) for all points of a surface.
template <class Of>
void for_each_point(const Model& model, Of&& of) {
  const BodySurface surface(model, model.bodies[0]);
  model.bodies[0].lattice.for_each_point([&](std::int64_t number, Vector at) {
    for (const BoundaryPoint& point : surface.of(static_cast<std::uint32_t>(number)))
      of(Components{at.x + point.from[0], at.y + point.from[1], 0}, point.normal);
  });
}

TEST(BodySurface, OfADiscIsItsRim) {
  int points = 0;
  for_each_point(model_of(Disc{{0.1, 0.2}, 8}), [&](const Components& place, const Components& normal) {
    const Components radius = {place[0] - 0.1, place[1] - 0.2, 0};
    // Differences of distances, over 1e-4: rounding in normals, and their error times the way to the rim.
    EXPECT_NEAR(std::sqrt(dot(radius, radius)), 8, 1e-6);
    EXPECT_NEAR(dot(radius, normal), 8, 1e-6);
    ++points;
  });
  // A side of 0.5 on each of the rows and columns, from both ends.
  EXPECT_EQ(points, 4 * 32);
}

TEST(BodySurface, OfABlockIsTheMiddlesOfItsParticlesSides) {
  int left = 0, points = 0;
  for_each_point(model_of(Box{{-2, -1}, {2, 1}}), [&](const Components& place, const Components& normal) {
    ++points;
    if (normal[0] > -0.5) return;
    ++left;
    EXPECT_NEAR(place[0], -2, 1e-12);
    EXPECT_NEAR(normal[1], 0, 1e-9);
  });
  EXPECT_EQ(points, 2 * (8 + 4));
  EXPECT_EQ(left, 4);
}

/// What a node at a place sees of a body.
NearbyParticles seen(const Model& model, const Components& node) {
  NearbyParticles near;
  const auto from = [&](const Components& place) { return Components{place[0] - node[0], place[1] - node[1], 0}; };
  const auto is_near = [](const Components& place) { return dot(place, place) <= nearby * nearby; };
  model.bodies[0].lattice.for_each_point([&](std::int64_t, Vector at) {
    const Components place = from({at.x, at.y, 0});
    if (is_near(place)) near.add(place, {0.0625, 0.0625, 0, 0, 0, 0});
  });
  for_each_point(model, [&](const Components& at, const Components& normal) {
    const Components place = from(at);
    if (is_near(place)) near.boundary.push_back({place, normal});
  });
  return near;
}

/// Discs of 12 cells in a radius that just touch, whichever way.
TEST(Meeting, OfDiscsHasTheNormalAndTheGapOfTheirRims) {
  constexpr double radius = 12;
  double turned = 0, count = 0;
  for (int angle = 0; angle <= 45; angle += 3) {
    const Components along = {std::cos(angle * pi / 180), std::sin(angle * pi / 180), 0};
    const Model a = model_of(Disc{{-radius * along[0], -radius * along[1]}, radius});
    const Model b = model_of(Disc{{radius * along[0], radius * along[1]}, radius});
    const auto found = meeting(2, seen(a, {}), seen(b, {}), 0.1);
    ASSERT_TRUE(found) << angle;
    turned += std::pow(std::acos(std::min(1.0, dot(found->normal, along))) * 180 / pi, 2);
    ++count;
    // What is 0.75 beside the middle lies behind it by 0.75^2 / (2 radius), and all of the mean between. Normals
    // are those of differences over 1e-4.
    EXPECT_GT(found->gap, -1e-6) << angle;
    EXPECT_LT(found->gap, 2 * 0.75 * 0.75 / (2 * radius)) << angle;
  }
  // Points along the rim are 0.35 to 0.5 apart, by up to half of that off even places: if the mean of sixteen, of
  // two rims, is off by 0.25 / sqrt(16), normals turn by that over the radius.
  EXPECT_LT(std::sqrt(turned / count), 0.0625 / radius * 180 / pi);
}

TEST(Meeting, IsNoneOfBodiesThatAreApart) {
  const Model a = model_of(Box{{-2, -2}, {2, 0}}), b = model_of(Box{{-2, 0.2}, {2, 2.2}});
  EXPECT_FALSE(meeting(2, seen(a, {}), seen(b, {}), 0.1));
}

TEST(Meeting, OfFacesIsExactNearACorner) {
  const Model a = model_of(Box{{-4, -2}, {4, 0}}), b = model_of(Box{{-4, 0.05}, {0, 2.05}});
  const auto found = meeting(2, seen(a, {0, 0, 0}), seen(b, {0, 0, 0}), 0.1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->normal[1], 1, 1e-9);
  EXPECT_NEAR(found->gap, 0.05, 1e-9);
}

}  // namespace
}  // namespace trajan
