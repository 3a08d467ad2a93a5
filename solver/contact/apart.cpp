#include "solver/contact/apart.h"

#include <cmath>

namespace trajan {
namespace {

/// Of hulls that are round; those of points are done after a few.
constexpr int most_rounds = 50;
constexpr double no_gap = 1e-6;

void add_to(Components& sum, double times, const Components& vector) {
  for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += times * vector[axis];
}

Components difference(const Components& a, const Components& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// The point of a field that is furthest along a unit vector.
Components foremost(const NearbyParticles& near, const Components& along) {
  std::size_t best = 0;
  double furthest = -HUGE_VAL;
  for (std::size_t p = 0; p < near.places.size(); ++p) {
    const double to = near.reach(p, along);
    if (!(to > furthest)) continue;
    furthest = to;
    best = p;
  }
  Components point = near.places[best];
  const Components from = product(near.ellipsoids[best], along);
  const double length = std::sqrt(dot(along, from));
  if (length > 0) add_to(point, 1 / length, from);
  for (const NearbyBoundary& boundary : near.boundary) {
    const double to = dot(boundary.place, along);
    if (!(to > furthest)) continue;
    furthest = to;
    point = boundary.place;
  }
  return point;
}

/// The point of the hull of some points that is nearest to the origin. There is at most one more of them than
/// axes.
class Nearest {
 public:
  explicit Nearest(const Components& only) : points_{only}, weights_{1}, count_(1) {}
  std::size_t count() const { return count_; }

  Components at() const {
    Components sum{};
    for (std::size_t i = 0; i < count_; ++i) add_to(sum, weights_[i], points_[i]);
    return sum;
  }

  /// Takes one more point into account, and drops those that do not matter any more.
  void add(const Components& point) {
    points_[count_] = point;
    weights_[count_++] = 0;
    for (;;) {
      const Weights plane = on_plane();
      // As far towards it as weights stay positive.
      std::size_t first = count_;
      double share = 1;
      for (std::size_t i = 0; i < count_; ++i) {
        const double until = weights_[i] > 0 ? weights_[i] / (weights_[i] - plane[i]) : 0;
        if (plane[i] > 0 || until > share) continue;
        share = until;
        first = i;
      }
      for (std::size_t i = 0; i < count_; ++i) weights_[i] += share * (plane[i] - weights_[i]);
      if (first == count_) return;
      drop(first);
    }
  }

 private:
  using Weights = std::array<double, 4>;

  /// Weights, perhaps negative, of the point that is nearest on the plane through all points, by orthogonalization
  /// of its edges.
  Weights on_plane() const {
    Components axes[4]{}, rest{};
    double along[4][4]{};
    add_to(rest, -1, points_[0]);
    for (std::size_t i = 1; i < count_; ++i) {
      add_to(axes[i], 1, points_[i]);
      add_to(axes[i], -1, points_[0]);
      const double length = std::sqrt(dot(axes[i], axes[i]));
      for (std::size_t j = 1; j < i; ++j) {
        along[j][i] = dot(axes[j], axes[i]);
        add_to(axes[i], -along[j][i], axes[j]);
      }
      along[i][i] = std::sqrt(dot(axes[i], axes[i]));
      // What lies on the plane through those before makes no difference.
      if (!(along[i][i] > 1e-9 * length)) along[i][i] = 0;
      for (double& component : axes[i]) component = along[i][i] > 0 ? component / along[i][i] : 0;
    }
    Weights weights{1};
    for (std::size_t i = count_; i-- > 1;) {
      double part = dot(axes[i], rest);
      for (std::size_t j = i + 1; j < count_; ++j) part -= along[i][j] * weights[j];
      weights[i] = along[i][i] > 0 ? part / along[i][i] : 0;
      weights[0] -= weights[i];
    }
    return weights;
  }

  void drop(std::size_t i) {
    for (--count_; i < count_; ++i) {
      points_[i] = points_[i + 1];
      weights_[i] = weights_[i + 1];
    }
  }

  std::array<Components, 4> points_;
  Weights weights_;
  std::size_t count_;
};

}  // namespace

bool are_apart(int axes, const NearbyParticles& first, const NearbyParticles& second, double by) {
  Components gap = difference(second.places[0], first.places[0]);
  Nearest nearest(gap);
  for (int round = 0; round < most_rounds; ++round) {
    const double distance = std::sqrt(dot(gap, gap));
    if (!(distance > by + no_gap)) return false;
    Components along{}, against{};
    add_to(along, 1 / distance, gap);
    add_to(against, -1, along);
    const Components next = difference(foremost(second, against), foremost(first, along));
    if (dot(next, along) > by) return true;
    nearest.add(next);
    if (nearest.count() > static_cast<std::size_t>(axes)) return false;
    gap = nearest.at();
  }
  return false;
}

}  // namespace trajan
