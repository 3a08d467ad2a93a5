#include "solver/model/selection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/model/sample_scene.h"

namespace trajan {
namespace {

struct Numbered {
  std::int64_t number;
  Vector place;
};

std::vector<Numbered> all_particles(const Body& body) {
  std::vector<Numbered> particles;
  body.lattice.for_each_point([&](std::int64_t number, Vector place) {
    particles.push_back({body.first_particle + number, place});
  });
  return particles;
}

/// One more has points that are not even.
std::vector<Body> bodies() {
  std::vector<Body> bodies = validate(sample_scene()).bodies;
  bodies.push_back(bodies.front());
  bodies.back().lattice = make_lattice(bodies.front().lattice.geometry, {-1, -1}, 1, 16, 2);
  bodies.back().lattice.number_points();
  bodies.back().lattice.place_at_gauss_points(16);
  return bodies;
}

TEST(Selection, NearestParticleIsTheOneThatASearchFinds) {
  for (const Body& body : bodies()) {
    for (int i = 0; i < 300; ++i) {
      const Vector place = {4 + 6 * std::sin(i), 0.5 + 1.7 * std::sin(5 * i)};
      const NearestParticle found = nearest_particle(body, place);
      double least = 1e9;
      for (const Numbered& p : all_particles(body)) {
        least = std::min(least, std::hypot(p.place.x - place.x, p.place.y - place.y));
      }
      EXPECT_DOUBLE_EQ(found.distance, least);
      const Numbered p = all_particles(body).at(static_cast<std::size_t>(found.particle - body.first_particle));
      EXPECT_DOUBLE_EQ(std::hypot(p.place.x - place.x, p.place.y - place.y), least);
    }
  }
}

TEST(Selection, OfEquallyNearParticlesTheFirstIsMeant) {
  const Body beam = bodies().front();
  // Between the four particles around a node.
  EXPECT_EQ(nearest_particle(beam, {0.125, 0.125}).particle, 0);
  EXPECT_EQ(nearest_particle(beam, {8, 0.5}).particle, 64 * 3 + 63);
}

TEST(Selection, RegionMeansTheParticlesThatASearchFinds) {
  for (const Body& body : bodies()) {
    for (int i = 0; i < 100; ++i) {
      const Vector corner = {4 + 3 * std::sin(i), 0.8 + std::sin(7 * i)};
      const Disc disc{corner, 0.1 + 0.02 * (i % 40)};
      const Box box{corner, {corner.x + 0.05 * (i % 13), corner.y + 0.03 * (i % 29)}};
      std::vector<std::int64_t> in_box, in_disc, expected_box, expected_disc;
      particles_in(body, box, in_box);
      particles_in(body, disc, in_disc);
      for (const Numbered& p : all_particles(body)) {
        if (distance_from(box, p.place) == 0) expected_box.push_back(p.number);
        if (distance_from(disc, p.place) == 0) expected_disc.push_back(p.number);
      }
      EXPECT_EQ(in_box, expected_box);
      EXPECT_EQ(in_disc, expected_disc);
      EXPECT_GE(most_particles_in(body, box), static_cast<double>(in_box.size()));
      EXPECT_GE(most_particles_in(body, disc), static_cast<double>(in_disc.size()));
    }
  }
}

TEST(Selection, DistanceFromARegionIsZeroInside) {
  EXPECT_EQ(distance_from(Box{{0, 0}, {2, 1}}, {1, 0.5}), 0);
  EXPECT_EQ(distance_from(Box{{0, 0}, {2, 1}}, {5, 5}), 5);
  EXPECT_EQ(distance_from(Disc{{0, 0}, 2}, {1, 1}), 0);
  EXPECT_EQ(distance_from(Disc{{0, 0}, 2}, {3, 4}), 3);
}

}  // namespace
}  // namespace trajan
