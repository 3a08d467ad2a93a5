#pragma once

#include <span>

#include "solver/model/components.h"

namespace trajan {

/// The unit normal of the plane that separates two clouds of points best, out of the first into the second: ridge
/// logistic regression of which cloud a point belongs to (Nairn, Hammerquist and Smith 2020; Bishop 2006, section
/// 4.3.3), in which both clouds weigh the same. Zero where there is no such direction. Neither may be empty.
/// Coordinates are in cells. Between clouds of two cells with two particles in a cell along each axis normals are
/// exact along rows, 2.6 degrees off (root of the mean square) where the plane is oblique to rows, gradients of
/// mass or volume 5; within a cell of a block's end 2.3 instead of 17.
Components separating_normal(int axes, std::span<const Components> first, std::span<const Components> second);

}  // namespace trajan
