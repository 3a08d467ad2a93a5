#pragma once

#include <vector>

#include "solver/scene/geometry.h"

/// Questions about regions of space. Meshes must have been read, and all numbers be finite. With a `slack`
/// points that close to the boundary belong to a region as well; with a negative one, only points that far
/// within it.
namespace trajan {

/// A part of a line along x.
struct Span {
  double from = 0;
  double to = 0;
};

/// In order, apart from each other.
using Spans = std::vector<Span>;

/// A box with sides along the axes around the region; lower > upper along an axis if it is empty.
Box bounds(const Region& region);

/// The parts of the line along x at (y, z) that lie in the region.
Spans spans(const Region& region, double y, double z, double slack);

/// Distance from the boundary, negative inside; for intersections and differences at most that outside.
double signed_distance(const Region& region, Vector place);

/// Distance of a place from a region, 0 inside; for intersections and differences at most that.
double distance_from(const Region& region, Vector place);

/// About how many numbers have to be looked at to know where one line meets the region.
double work_of_a_line(const Region& region);

}  // namespace trajan
