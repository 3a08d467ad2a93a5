#include "solver/surfaces/spline_faces.h"

namespace trajan {

void SplineFaces::weigh(const PointFunctions& functions, int first, double place, double* weight,
                        double* slope) const {
  functions.weigh(place, weight, slope);
  const int last = functions.nodes - 1;
  if (first != lower && first + last != upper) return;
  for (double* sum : {weight, slope}) put_value_on_face(functions, first == lower ? 0 : last, sum);
}

void put_value_on_face(const PointFunctions& functions, int face, double* coefficients) {
  double value[most_nodes_along], unused[most_nodes_along];
  functions.weigh(face, value, unused);
  const double share = coefficients[face] / value[face];
  for (int n = 0; n < functions.nodes; ++n) coefficients[n] -= share * value[n];
  coefficients[face] = share;
}

}  // namespace trajan
