#pragma once

#include <algorithm>

#include "solver/surfaces/point_functions.h"

namespace trajan {

/// Splines along an axis up to faces of the domain, beyond which there are no nodes. Near a face they are the
/// polynomials of the nearest stencil all of whose nodes exist, as if there were no knot in between (the
/// not-a-knot end of de Boor 1978, chapter IV), so that they reproduce polynomials of their degree up to the face.
/// The node on the face stands for the value there. Weights near a face are negative, of quadratic splines down to
/// -1/16. Linear extrapolation (`fold`) has no negative ones, but no second derivative at the face either, by
/// which modes converge with the third order only.
struct SplineFaces {
  double lower,
      upper;  ///< the nodes on the faces, counted from anywhere; at least as many apart as a stencil has nodes

  /// The first node of the nearest stencil whose nodes exist.
  int inside(int first, const PointFunctions& functions) const {
    return static_cast<int>(std::clamp<double>(first, lower, upper - (functions.nodes - 1)));
  }
  /// Weights and slopes of such a stencil, at a place counted from its first node.
  void weigh(const PointFunctions& functions, int first, double place, double* weight, double* slope) const;
};

/// Of a sum of coefficients of splines' nodes, the first one (`face` 0) or the last one of which lies on a face:
/// what it is if that node's coefficient is the value there.
void put_value_on_face(const PointFunctions& functions, int face, double* coefficients);

}  // namespace trajan
