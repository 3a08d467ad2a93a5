#include "solver/contact/separating_plane.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace trajan {
namespace {

/// Of the square of the normal. Less hardly turns it any more, more draws it to the line between the clouds'
/// middles.
constexpr double ridge = 1e-5;
/// Of the plane's place, which it need not have but for clouds on top of each other.
constexpr double least_curvature = 1e-9;
constexpr int most_iterations = 20;
/// A normal that still turns by less, as a tangent, is found.
constexpr double least_turn = 1e-3;

/// A plane in N axes: N components of a normal and an offset, and the slope of what they are to make smallest.
template <int N>
struct Regression {
  using Vector = Eigen::Matrix<double, N + 1, 1>;
  using Matrix = Eigen::Matrix<double, N + 1, N + 1>;
  struct Objective {
    Vector gradient;
    Matrix curvature;
  };

  std::span<const Components> clouds[2];

  Objective at(const Vector& plane) const {
    Objective of;
    of.gradient = ridge * plane;
    of.gradient[N] = 0;
    of.curvature = ridge * Matrix::Identity();
    of.curvature(N, N) = least_curvature;
    for (int c = 0; c < 2; ++c) {
      const double label = c == 0 ? -1 : 1, weight = 1 / static_cast<double>(clouds[c].size());
      for (const Components& point : clouds[c]) {
        Vector z;
        for (int axis = 0; axis < N; ++axis) z[axis] = point[static_cast<std::size_t>(axis)];
        z[N] = 1;
        // Derivatives of log(1 + exp(-margin)), without overflow.
        const double margin = label * z.dot(plane), power = std::exp(-std::abs(margin));
        const double wrong = (margin > 0 ? power : 1) / (1 + power);
        of.gradient -= (weight * label * wrong) * z;
        of.curvature.noalias() += (weight * wrong * (1 - wrong)) * z * z.transpose();
      }
    }
    return of;
  }

  /// How far a step turns the normal of a plane, as a tangent.
  static double turn(const Vector& plane, const Vector& step) {
    const auto normal = plane.template head<N>();
    const auto change = step.template head<N>();
    const double square = normal.squaredNorm();
    if (square == 0) return 1;
    return std::sqrt(std::max(0.0, change.squaredNorm() / square - std::pow(normal.dot(change) / square, 2)));
  }

  Components normal() const {
    Vector plane = Vector::Zero();
    Objective now = at(plane);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      Vector step = -now.curvature.ldlt().solve(now.gradient);
      Objective next = at(plane + step);
      // It is convex: along the step its slope grows from below 0, and must not come out steeper.
      const double slope = -now.gradient.dot(step);
      for (int halving = 0; halving < 30 && !(next.gradient.dot(step) <= slope); ++halving) {
        step *= 0.5;
        next = at(plane + step);
      }
      const bool found = turn(plane, step) <= least_turn;
      plane += step;
      now = next;
      if (found) break;
    }
    Components normal{};
    const double length = plane.template head<N>().norm();
    for (int axis = 0; axis < N && length > 0; ++axis)
      normal[static_cast<std::size_t>(axis)] = plane[axis] / length;
    return normal;
  }
};

}  // namespace

Components separating_normal(int axes, std::span<const Components> first, std::span<const Components> second) {
  if (axes == 1) return Regression<1>{{first, second}}.normal();
  if (axes == 2) return Regression<2>{{first, second}}.normal();
  return Regression<3>{{first, second}}.normal();
}

}  // namespace trajan
