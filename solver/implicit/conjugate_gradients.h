#pragma once

#include <Eigen/Core>
#include <cmath>

namespace trajan {

struct Gradients {
  enum class End { converged, too_slow, indefinite };
  End end = End::converged;
  int iterations = 0;
  double residual = 0;  ///< as a share of the right-hand side, of the answer itself
};

/// Conjugate gradients (Hestenes and Stiefel 1952) from x = 0 until the residual of a symmetric system is as small
/// as asked for, with Operator::multiply(x, y) and Operator::precondition(r, z). The residual that is carried
/// along drifts off by rounding; so it is formed again at the end, and if it is not that small, iterations begin
/// anew from there. Too slow: more than `most` iterations are needed, or will be at the rate up to `trial` of
/// them. Indefinite: x is a direction along which the matrix, or the preconditioner, is not positive.
template <class Operator>
Gradients conjugate_gradients(Operator& of, const Eigen::VectorXd& right, double tolerance, int trial, int most,
                              Eigen::VectorXd& x) {
  constexpr int most_restarts = 3;
  using End = Gradients::End;
  const double scale = right.norm();
  Eigen::VectorXd residual = right, z, direction, product;
  x.setZero(right.size());
  double left = scale;
  int iterations = 0, restarts = 0;
  const auto end = [&](End how) { return Gradients{how, iterations, scale > 0 ? left / scale : 0}; };
  while (!(left <= tolerance * scale)) {
    double slope = 0;
    direction.setZero(right.size());
    while (!(left <= tolerance * scale)) {
      if (iterations == most) return end(End::too_slow);
      if (iterations == trial && !(left <= std::pow(tolerance, double(trial) / most) * scale))
        return end(End::too_slow);
      ++iterations;
      of.precondition(residual, z);
      const double next = residual.dot(z);
      direction = z + (slope > 0 ? next / slope : 0) * direction;
      slope = next;
      of.multiply(direction, product);
      const double curvature = direction.dot(product);
      if (!(slope > 0 && curvature > 0)) {
        x = direction;
        return end(End::indefinite);
      }
      x += slope / curvature * direction;
      residual -= slope / curvature * product;
      left = residual.norm();
    }
    of.multiply(x, product);
    residual = right - product;
    left = residual.norm();
    if (restarts++ == most_restarts && !(left <= tolerance * scale)) return end(End::too_slow);
  }
  return end(End::converged);
}

}  // namespace trajan
