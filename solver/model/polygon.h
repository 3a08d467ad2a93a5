#pragma once

#include "solver/model/geometry.h"

/// Questions about polygons of at least three corners whose edges do not cross.
namespace trajan {

Box bounds_of(const Polygon& polygon);

/// The parts of the line along x at y in the polygon.
Spans spans_of(const Polygon& polygon, double y, double slack);

/// Distance from the edges, negative inside.
double distance_of(const Polygon& polygon, Vector place);

/// Index of a corner at which an edge begins that meets another edge than its neighbours; -1: none. Takes
/// time with the square of the corners.
int first_crossing(const Polygon& polygon);

}  // namespace trajan
