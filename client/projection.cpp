#include "client/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_set>

#include "client/exit_code.h"

namespace trajan::client {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The viewer stands at this azimuth, from -y towards x, and elevation.
Projection from_direction(double azimuth, double elevation) {
  const double sa = std::sin(azimuth), ca = std::cos(azimuth), se = std::sin(elevation), ce = std::cos(elevation);
  return {{ca, sa, 0}, {-sa * se, ca * se, ce}, {sa * ce, -ca * ce, se}, "", ""};
}

}  // namespace

Projection projection(const std::string& view) {
  if (view == "x") return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, "y", "z"};
  if (view == "y") return {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, "x", "z"};
  if (view == "z") return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, "x", "y"};
  if (view == "oblique") return from_direction(0.55, 0.45);
  throw CommandError(ExitCode::usage, fmt::format("\"{}\" is not a view", view), "use x, y, z or oblique");
}

std::vector<Projected> project(const std::vector<Point>& points, const Projection& projection) {
  std::vector<Projected> projected;
  projected.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    projected.push_back(
        {dot(points[i], projection.right), dot(points[i], projection.up), dot(points[i], projection.towards), i});
  }
  std::ranges::stable_sort(projected, {}, &Projected::depth);
  return projected;
}

std::vector<Projected> without_hidden(const std::vector<Projected>& back_to_front, double radius) {
  // A raster so fine that whoever covers a square's centre covers nearly all of it.
  constexpr int squares_per_radius = 4;
  const double side = radius / squares_per_radius;
  std::unordered_set<std::uint64_t> covered;
  const auto covers_more = [&](const Projected& ball) {
    const auto column = static_cast<std::int64_t>(std::floor(ball.x / side));
    const auto row = static_cast<std::int64_t>(std::floor(ball.y / side));
    bool more = false;
    for (std::int64_t j = row - squares_per_radius; j <= row + squares_per_radius; ++j) {
      for (std::int64_t i = column - squares_per_radius; i <= column + squares_per_radius; ++i) {
        const double x = (static_cast<double>(i) + 0.5) * side, y = (static_cast<double>(j) + 0.5) * side;
        if (std::hypot(x - ball.x, y - ball.y) > radius) continue;
        const auto key = static_cast<std::uint64_t>(i) << 32 ^ (static_cast<std::uint64_t>(j) & 0xffffffff);
        more |= covered.insert(key).second;
      }
    }
    return more;
  };
  std::vector<Projected> visible;
  std::copy_if(back_to_front.rbegin(), back_to_front.rend(), std::back_inserter(visible), covers_more);
  std::reverse(visible.begin(), visible.end());
  return visible;
}

}  // namespace trajan::client
