#include "solver/surfaces/point_functions.h"

#include "solver/shapes/shapes.h"

namespace trajan {
namespace {

template <class Shape>
constexpr PointFunctions functions_of(double lowest, double highest, bool averaged = false) {
  return {Shape::nodes,
          lowest,
          highest,
          Shape::folds,
          averaged,
          &Shape::first_node,
          [](double place, double* weight, double* slope) {
            double weights[Shape::nodes], slopes[Shape::nodes];
            Shape::weigh(place, 0, weights, slopes);
            for (int n = 0; n < Shape::nodes; ++n) weight[n] = weights[n], slope[n] = slopes[n];
          }};
}

constexpr PointFunctions linear = functions_of<Linear>(0, 1);
constexpr PointFunctions averaged_linear = functions_of<Linear>(0, 1, true);
constexpr PointFunctions quadratic_bspline = functions_of<QuadraticBspline>(0.5, 1.5);
constexpr PointFunctions cubic_bspline = functions_of<CubicBspline>(1, 2);
constexpr PointFunctions bernstein = functions_of<Bernstein>(0, 2);

}  // namespace

const PointFunctions& point_functions(std::string_view shape_functions) {
  if (shape_functions == QuadraticBspline::name) return quadratic_bspline;
  if (shape_functions == CubicBspline::name) return cubic_bspline;
  if (shape_functions == Bernstein::name) return bernstein;
  return shape_functions == Linear::name ? linear : averaged_linear;
}

void fold(const PointFunctions& functions, int below, int above, double* values) {
  const int last = functions.nodes - 1;
  for (int n = 0; n < below && n + 2 <= last; ++n) {
    values[n + 1] += 2 * values[n];
    values[n + 2] -= values[n];
    values[n] = 0;
  }
  for (int n = last; n > last - above && n >= 2; --n) {
    values[n - 1] += 2 * values[n];
    values[n - 2] -= values[n];
    values[n] = 0;
  }
}

}  // namespace trajan
