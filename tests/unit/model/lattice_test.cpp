#include "solver/model/lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace trajan {
namespace {

Lattice lattice_of(const Region& geometry, Vector origin, double cell, int particles_per_cell_side, int axes) {
  Lattice lattice = make_lattice(geometry, origin, cell, particles_per_cell_side, axes);
  lattice.number_points();
  return lattice;
}

std::int64_t count_by_looking(const Lattice& lattice, const Disc& disc) {
  std::int64_t points = 0;
  for (std::int64_t row = -2; row < lattice.rows + 2; ++row) {
    for (std::int64_t column = -2; column < lattice.columns + 2; ++column) {
      const Vector point = {lattice.first.x + static_cast<double>(column) * lattice.spacing.x,
                            lattice.first.y + static_cast<double>(row) * lattice.spacing.y};
      // The same slack at the rim as the lattice's own.
      if (std::hypot(point.x - disc.centre.x, point.y - disc.centre.y) <= disc.radius + 1e-9 * lattice.spacing.x) {
        ++points;
      }
    }
  }
  return points;
}

TEST(Lattice, FillsABoxWithTheAskedParticlesPerCell) {
  const Lattice lattice = lattice_of(Box{{0, 0}, {8, 1}}, {-1, -1}, 0.25, 2, 2);
  EXPECT_EQ(lattice.columns, 64);
  EXPECT_EQ(lattice.rows, 8);
  EXPECT_EQ(lattice.count(), 512);
  EXPECT_EQ(lattice.spacing.x, 0.125);
  EXPECT_EQ(lattice.point(0, 0).x, 0.0625);
  EXPECT_EQ(lattice.point(63, 7).y, 0.9375);
}

TEST(Lattice, FitsTheSidesOfABoxExactly) {
  // 0.9 / 0.25 = 3.6 and 0.33 / 0.25 = 1.32 particles are asked for.
  const Box box{{0.1, 0.2}, {1.0, 0.53}};
  const Lattice lattice = lattice_of(box, {0, 0}, 0.5, 2, 2);
  EXPECT_EQ(lattice.columns, 4);
  EXPECT_EQ(lattice.rows, 1);
  // Half a spacing inside each side, to rounding.
  EXPECT_DOUBLE_EQ(lattice.point(0, 0).x, 0.1 + 0.9 / 8);
  EXPECT_DOUBLE_EQ(lattice.point(3, 0).x, 1.0 - 0.9 / 8);
  EXPECT_DOUBLE_EQ(lattice.point(0, 0).y, 0.365);
}

TEST(Lattice, HasOneParticleInABoxThatIsSmallerThanASpacing) {
  const Lattice lattice = lattice_of(Box{{0, 0}, {0.01, 0.02}}, {0, 0}, 1, 2, 2);
  EXPECT_EQ(lattice.count(), 1);
  EXPECT_DOUBLE_EQ(lattice.point(0, 0).y, 0.01);
}

TEST(Lattice, FillsADiscWithTheSubCellsOfTheGrid) {
  const Disc disc{{0.5, 0.5}, 0.3};
  const Lattice lattice = lattice_of(disc, {0, 0}, 0.1, 2, 2);
  const double index = lattice.first.x / lattice.spacing.x - 0.5;
  EXPECT_NEAR(index, std::round(index), 1e-12);
  EXPECT_EQ(lattice.count(), count_by_looking(lattice, disc));
}

TEST(Lattice, CountsDiscsAsAPointByPointSearchDoes) {
  for (int i = 0; i < 200; ++i) {
    const Disc disc{{std::sin(i), std::cos(3 * i)}, 0.02 + 0.01 * (i % 37)};
    const Lattice lattice = lattice_of(disc, {-0.7, 0.3}, 0.1, 1 + i % 4, 2);
    EXPECT_EQ(lattice.count(), count_by_looking(lattice, disc)) << i;
  }
}

TEST(Lattice, KeepsPointsOnTheRimWhateverTheRounding) {
  // Points at 0.05 + 0.1 i; the centre is one of them, and the rim goes through (centre +- 0.3, centre).
  const Lattice lattice = lattice_of(Disc{{0.65, 0.65}, 0.3}, {0, 0}, 0.1, 1, 2);
  EXPECT_EQ(lattice.columns, 7);
  EXPECT_EQ(lattice.rows, 7);
  EXPECT_EQ(lattice.columns_in_row(3).at(0).end - lattice.columns_in_row(3).at(0).begin, 7);
  EXPECT_EQ(lattice.columns_in_row(0).at(0).end - lattice.columns_in_row(0).at(0).begin, 1);
}

TEST(Lattice, DiscHasTheSymmetryOfItsPlaceInTheGrid) {
  const Lattice lattice = lattice_of(Disc{{0.2, 0.2}, 0.1737}, {0, 0}, 0.01, 2, 2);
  for (std::int64_t row = 0; row < lattice.rows; ++row) {
    const auto here = lattice.columns_in_row(row).at(0);
    const auto mirrored = lattice.columns_in_row(lattice.rows - 1 - row).at(0);
    EXPECT_EQ(here.begin, mirrored.begin);
    EXPECT_EQ(here.end, mirrored.end);
    EXPECT_EQ(here.begin, lattice.columns - here.end);
  }
}

TEST(Lattice, DiscMayCatchNoPoint) { EXPECT_EQ(lattice_of(Disc{{0.5, 0.5}, 0.1}, {0, 0}, 1, 2, 2).count(), 0); }

TEST(Lattice, AreaOfADiscConvergesToThatOfTheCircle) {
  // The error of counting lattice points is of the order of one row of points along the rim: 2 pi r s.
  for (const double spacing : {0.1, 0.01, 0.001}) {
    const Lattice lattice = lattice_of(Disc{{0.1, 0.2}, 1}, {-2, -2}, spacing, 1, 2);
    const double area = static_cast<double>(lattice.count()) * spacing * spacing;
    EXPECT_NEAR(area, std::numbers::pi, 2 * std::numbers::pi * spacing);
  }
}

// n points along a side are exact for degree 2 n - 1 (Abramowitz and Stegun 1964, 25.4.29), to rounding of some
// hundred terms.
TEST(Lattice, GaussPointsIntegratePolynomialsOverABox) {
  for (int n = 1; n <= 16; ++n) {
    Lattice lattice = lattice_of(Box{{1, 2}, {2, 2.5}}, {0, 0}, 0.5, n, 2);
    lattice.place_at_gauss_points(n);
    const int degree = 2 * n - 1;
    double sum = 0;
    lattice.for_each_point([&](std::int64_t number, Vector at) {
      EXPECT_EQ(lattice.point_of(number).x, at.x);
      sum += lattice.share(number, 2) * std::pow(at.x - 1, degree) * std::pow(2 * (at.y - 2), degree);
    });
    const double mean = 1.0 / (2 * n) / (2 * n);
    EXPECT_NEAR(sum / static_cast<double>(lattice.count()), mean, 1e-13) << n;
  }
}

TEST(Lattice, EvenPointsHaveTheirVolumeAlone) {
  EXPECT_EQ(lattice_of(Box{{0, 0}, {8, 1}}, {-1, -1}, 0.25, 2, 2).share(17, 2), 1);
}

TEST(Lattice, SizeNeedsNoCounting) {
  EXPECT_EQ(lattice_size(Box{{0, 0}, {8, 1}}, 0.25, 2, 2).points, 512);
  EXPECT_GT(lattice_size(Box{{0, 0}, {1e300, 1}}, 1e-3, 2, 2).points, 1e300);
  const LatticeSize disc = lattice_size(Disc{{0, 0}, 1}, 0.01, 2, 2);
  EXPECT_GE(disc.points, static_cast<double>(lattice_of(Disc{{0, 0}, 1}, {-2, -2}, 0.01, 2, 2).count()));
  EXPECT_EQ(disc.work, 401) << "its rows";
}

}  // namespace
}  // namespace trajan
