#include "solver/model/geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/model/lattice.h"
#include "solver/model/polygon.h"

namespace trajan {
namespace {

constexpr double pi = std::numbers::pi;

const Polygon l_shape = {{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}};

/// Regions of every kind, simple and combined, of about size 1.
std::vector<Region> regions() {
  const Cylinder upright = {{0.1, 0.2, -0.5}, {0.1, 0.2, 0.6}, 0.4};
  const Cylinder oblique = {{-0.3, -0.2, -0.1}, {0.5, 0.4, 0.6}, 0.3};
  const Sphere ball = {{0.1, 0, 0.2}, 0.7};
  const Box block = {{-0.4, -0.5, -0.6}, {0.7, 0.3, 0.4}};
  return {block,
          ball,
          upright,
          oblique,
          Cylinder{{-0.5, 0, 0}, {0.5, 0, 0}, 0.5},
          Union{{{upright}, {oblique}, {Sphere{{0, 0.9, 0}, 0.3}}}},
          Intersection{{{ball}, {block}}},
          Difference{{{ball}, {oblique}, {Box{{0, 0, 0}, {1, 1, 1}}}}},
          Difference{{{Union{{{block}, {oblique}}}}, {Intersection{{{ball}, {upright}}}}}}};
}

bool in_spans(const Region& region, Vector place) {
  for (const Span& span : spans(region, place.y, place.z, 0))
    if (place.x >= span.from && place.x <= span.to) return true;
  return false;
}

TEST(Geometry, LinesMeetARegionWhereItsPointsAre) {
  for (const Region& region : regions()) {
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vector place = {std::sin(i), std::sin(3.7 * i + 1), std::sin(5.3 * i + 2)};
      EXPECT_EQ(in_spans(region, place), signed_distance(region, place) <= 0) << region.index() << " " << i;
      inside += in_spans(region, place) ? 1 : 0;
    }
    EXPECT_GT(inside, 20) << region.index();
  }
}

TEST(Geometry, BoundsHoldAllPoints) {
  for (const Region& region : regions()) {
    const Box box = bounds(region);
    for (int i = 0; i < 3000; ++i) {
      const Vector place = {std::sin(i), std::sin(3.7 * i + 1), std::sin(5.3 * i + 2)};
      if (!in_spans(region, place)) continue;
      EXPECT_LE(signed_distance(box, place), 1e-15) << region.index();
    }
  }
}

TEST(Geometry, DistanceIsThatOfTheNearestPoint) {
  EXPECT_DOUBLE_EQ(signed_distance(Box{{0, 0, 0}, {2, 1, 3}}, {5, 5, 3}), 5);
  EXPECT_DOUBLE_EQ(signed_distance(Box{{0, 0, 0}, {2, 1, 3}}, {1, 0.9, 1}), 0.9 - 1);
  EXPECT_DOUBLE_EQ(signed_distance(Box{{0, 0}, {2, 1}}, {0.5, 0.75}), -0.25) << "flat along z";
  EXPECT_DOUBLE_EQ(signed_distance(Cylinder{{0, 0, 0}, {0, 0, 2}, 1}, {4, 0, 6}), 5);
  EXPECT_DOUBLE_EQ(signed_distance(Cylinder{{0, 0, 0}, {0, 0, 2}, 1}, {0.5, 0, 1}), -0.5);
  EXPECT_DOUBLE_EQ(signed_distance(l_shape, {4, 2}), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(signed_distance(l_shape, {0.5, 1.5}), -0.5);
}

TEST(Geometry, HoleBelongsToItsRimAndNotToItsInside) {
  const Difference ring = {{{Disc{{0, 0}, 2}}, {Disc{{0, 0}, 1}}}};
  EXPECT_EQ(distance_from(ring, {1, 0}), 0);
  EXPECT_DOUBLE_EQ(distance_from(ring, {0.25, 0}), 0.75);
  const Spans parts = spans(ring, 0, 0, 0);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].to, -1);
  EXPECT_EQ(parts[1].from, 1);
}

TEST(Geometry, PolygonIsCutByLinesThroughItsCornersToo) {
  for (const double y : {0.0, 0.5, 1.0, 1.5}) {
    const Spans parts = spans(l_shape, y, 0, 0);
    ASSERT_EQ(parts.size(), 1u) << y;
    EXPECT_EQ(parts[0].from, 0);
    EXPECT_EQ(parts[0].to, y < 1 ? 3 : 1);
  }
  EXPECT_TRUE(spans(l_shape, 2.5, 0, 0).empty());
}

TEST(Geometry, PolygonThatCrossesItselfIsFound) {
  EXPECT_EQ(first_crossing(l_shape), -1);
  EXPECT_EQ(first_crossing({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), 0);
  EXPECT_GE(first_crossing({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}), 0) << "a corner given twice";
  EXPECT_GE(first_crossing({{{0, 0}, {2, 0}, {1, 0}, {0, 1}}}), 0) << "an edge that folds back";
}

struct Filled {
  std::string name;
  Region region;
  int axes;
  double volume;
  double surface;
};

std::vector<Filled> filled() {
  return {{"ring", Difference{{{Disc{{0, 0}, 1}}, {Disc{{0.1, 0}, 0.5}}}}, 2, pi * 0.75, 2 * pi * 1.5},
          {"polygon", l_shape, 2, 4, 10},
          {"sphere", Sphere{{0.1, 0.2, 0.3}, 1}, 3, 4 * pi / 3, 4 * pi},
          {"hollow sphere", Difference{{{Sphere{{0, 0, 0}, 1}}, {Sphere{{0, 0, 0}, 0.5}}}}, 3, 7 * pi / 6, 5 * pi},
          {"oblique cylinder", Cylinder{{-1, -1, -1}, {1, 1, 1}, 0.5}, 3, pi / 4 * std::sqrt(12.0),
           pi * std::sqrt(12.0) + pi / 2}};
}

TEST(Geometry, VolumeOfTheParticlesConvergesToThatOfTheRegion) {
  for (const auto& [name, region, axes, volume, surface] : filled()) {
    for (const double spacing : {0.1, 0.05, 0.025}) {
      Lattice lattice = make_lattice(region, {-3, -3, -3}, spacing, 1, axes);
      lattice.number_points();
      const double sum = static_cast<double>(lattice.count()) * std::pow(spacing, axes);
      // No more is wrong than half a layer of particles all over the surface.
      EXPECT_NEAR(sum, volume, surface * spacing / 2) << name << " " << spacing;
    }
  }
}

TEST(Geometry, NumbersOfParticlesLeadBackToThem) {
  for (const Filled& filling : filled()) {
    Lattice lattice = make_lattice(filling.region, {-3, -3, -3}, 0.2, 1, filling.axes);
    lattice.number_points();
    std::int64_t visited = 0;
    lattice.for_each_point([&](std::int64_t number, Vector at) {
      EXPECT_EQ(number, visited++);
      const Vector found = lattice.point_of(number);
      EXPECT_EQ(found.x, at.x);
      EXPECT_EQ(found.y, at.y);
      EXPECT_EQ(found.z, at.z);
    });
    EXPECT_EQ(visited, lattice.count());
  }
}

TEST(Geometry, BoxesFillBarsAndSolids) {
  Lattice bar = make_lattice(Box{{1, 0}, {3, 0}}, {0, 0}, 0.5, 2, 1);
  bar.number_points();
  EXPECT_EQ(bar.count(), 8);
  EXPECT_EQ(bar.point_of(7).x, 2.875);
  EXPECT_EQ(bar.point_of(7).y, 0);
  Lattice solid = make_lattice(Box{{0, 0, 0}, {1, 2, 3}}, {0, 0, 0}, 1, 2, 3);
  solid.number_points();
  EXPECT_EQ(solid.count(), 6 * 8);
  EXPECT_EQ(solid.point_of(47).z, 2.75);
  EXPECT_EQ(solid.point_of(2).y, 0.75);
}

}  // namespace
}  // namespace trajan
