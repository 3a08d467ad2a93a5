#pragma once

#include "solver/model/model.h"

namespace trajan {

/// Whether splines keep their degree up to faces of the domain (solver/surfaces/spline_faces.h): in implicit
/// analyses without lumped masses, which their weights might make negative, and in domains of at least four cells
/// a side. Not with a locking remedy: particles near a face would share their volume over more than a cell, which
/// is too soft by the first order (Cook's membrane: 0.9 % instead of 0.1 %).
bool splines_keep_degree(const Model& model);

}  // namespace trajan
