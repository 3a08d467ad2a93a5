#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/snapshot_file.h"

namespace trajan::client {

/// From where a solid is looked at: a parallel projection.
struct Projection {
  Point right, up, towards;         ///< unit vectors: of the picture, and to the viewer
  std::string_view x_axis, y_axis;  ///< what lies along the picture's sides; empty: no axis does
};

/// "x", "y" or "z": along this axis, with z up if that is not it; "oblique": from the front, the right and
/// above. Throws CommandError (usage) for another view.
Projection projection(const std::string& view);

/// A particle on the picture: its place in the plane, how near it is to the viewer, and whose it is.
struct Projected {
  double x = 0, y = 0, depth = 0;
  std::size_t particle = 0;
};

/// All particles, the farthest first.
std::vector<Projected> project(const std::vector<Point>& points, const Projection& projection);

/// Without those that nearer ones hide wholly, all being balls of this radius.
std::vector<Projected> without_hidden(const std::vector<Projected>& back_to_front, double radius);

}  // namespace trajan::client
