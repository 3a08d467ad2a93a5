#include "solver/contact/separating_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

/// Normals of clouds as nodes see them: particles within two cells, two in a cell along each axis.
namespace trajan {
namespace {

using std::numbers::pi;

constexpr double half = 0.25;

using Inside = std::function<bool(double x, double y)>;

std::vector<Components> cloud(const Inside& inside) {
  std::vector<Components> points;
  for (double x = -2 + half; x < 2; x += 2 * half)
    for (double y = -2 + half; y < 2; y += 2 * half)
      if (x * x + y * y <= 4 && inside(x, y)) points.push_back({x, y, 0});
  return points;
}

double degrees_between(const Components& a, const Components& b) {
  return std::acos(std::min(1.0, dot(a, b))) * 180 / pi;
}

TEST(SeparatingNormal, IsExactBetweenFacesAlongTheirParticles) {
  const Components normal = separating_normal(2, cloud([](double, double y) { return y < 0; }),
                                              cloud([](double, double y) { return y > 0; }));
  // Of the fit, which stops at a turn of a thousandth that the next iteration would have made much smaller.
  EXPECT_NEAR(degrees_between(normal, {0, 1, 0}), 0, 1e-3);
}

/// The steps between rows of particles turn it. What tests and scenes with curved bodies allow for.
TEST(SeparatingNormal, IsLessThanThreeDegreesOffBetweenObliqueBodies) {
  double sum = 0, count = 0;
  for (int angle = 0; angle <= 45; ++angle)
    for (double offset : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
      const Components along = {std::sin(angle * pi / 180), std::cos(angle * pi / 180), 0};
      const auto ahead = [&](double x, double y) { return along[0] * x + along[1] * y - offset; };
      const Components normal = separating_normal(2, cloud([&](double x, double y) { return ahead(x, y) < 0; }),
                                                  cloud([&](double x, double y) { return ahead(x, y) > 0; }));
      sum += std::pow(degrees_between(normal, along), 2);
      ++count;
    }
  EXPECT_LT(std::sqrt(sum / count), 3);
}

/// What tests and scenes with blocks allow for; gradients of mass are 17 degrees off there.
TEST(SeparatingNormal, IsTwoAndAHalfDegreesOffWithinACellOfABlocksEnd) {
  double sum = 0, count = 0;
  for (double end = -1; end <= 1; end += 0.25) {
    const Components normal = separating_normal(2, cloud([](double, double y) { return y < 0; }),
                                                cloud([&](double x, double y) { return y > 0 && x < end; }));
    const double off = degrees_between(normal, {0, 1, 0});
    EXPECT_LT(off, 5) << end;
    sum += off * off;
    ++count;
  }
  EXPECT_LT(std::sqrt(sum / count), 2.5);
}

}  // namespace
}  // namespace trajan
