#include "solver/contact/meeting.h"

#include <algorithm>
#include <cmath>

#include "solver/contact/apart.h"

namespace trajan {
namespace {

Components negative(const Components& v) { return {-v[0], -v[1], -v[2]}; }

/// The mean normal of the surface that faces a direction; zero if there is none.
Components mean_normal(const NearbyParticles& near, const Components& along) {
  Components sum{};
  double weights = 0;
  for (const NearbyBoundary& point : near.boundary) {
    if (!(dot(point.normal, along) > facing)) continue;
    const double w = falling_weight(dot(point.place, point.place), nearby);
    weights += w;
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += w * point.normal[axis];
  }
  for (double& component : sum) component = weights > 0 ? component / weights : 0;
  return sum;
}

/// How far the surface that faces a direction is along it, in the mean over what is beside the node.
double mean_reach(const NearbyParticles& near, const Components& along) {
  double foremost = -HUGE_VAL, sum = 0, weights = 0;
  for (const NearbyBoundary& point : near.boundary)
    if (dot(point.normal, along) > facing) foremost = std::max(foremost, dot(point.place, along));
  for (const NearbyBoundary& point : near.boundary) {
    const double to = dot(point.place, along);
    if (!(dot(point.normal, along) > facing) || to < foremost - layer) continue;
    const double w = falling_weight(dot(point.place, point.place) - to * to, beside);
    weights += w;
    sum += w * to;
  }
  return weights > 0 ? sum / weights : foremost;
}

/// Nothing if one of them has no boundary there.
std::optional<Meeting> of_boundaries(Components normal, const NearbyParticles& first,
                                     const NearbyParticles& second) {
  for (int round = 0; round < 2; ++round) {
    const Components a = mean_normal(first, normal), b = mean_normal(second, negative(normal));
    if (dot(a, a) == 0 || dot(b, b) == 0) return std::nullopt;
    const Components sum = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    const double length = std::sqrt(dot(sum, sum));
    normal = {sum[0] / length, sum[1] / length, sum[2] / length};
  }
  const double to_first = mean_reach(first, normal), to_second = mean_reach(second, negative(normal));
  if (std::isinf(to_first) || std::isinf(to_second)) return std::nullopt;
  return Meeting{normal, -to_first - to_second};
}

}  // namespace

std::optional<Meeting> meeting(int axes, const NearbyParticles& first, const NearbyParticles& second, double by) {
  if (are_apart(axes, first, second, by)) return std::nullopt;
  const Components normal = separating_normal(axes, first.places, second.places);
  if (dot(normal, normal) == 0) return std::nullopt;
  if (const auto found = of_boundaries(normal, first, second)) return found;
  return Meeting{normal, -reach(first, normal) - reach(second, negative(normal))};
}

}  // namespace trajan
