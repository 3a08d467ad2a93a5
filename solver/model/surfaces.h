#pragma once

#include <vector>

#include "solver/model/model.h"

/// Quadrature points of bodies' surfaces.
namespace trajan {

/// The axis that is normal to a side of a box, and whether it is the upper one.
int normal_axis(Edge edge);
bool is_upper(Edge edge);

/// How many points `edge_points` gives, and at most that of a polygon.
double count_edge_points(const Body& body, Edge edge, int axes);

/// Two Gauss points along each axis of each particle's part of an edge of a box: a resultant is exact for
/// profiles up to the third degree, its moment up to the second; for others the error is of fourth order
/// in the spacing. Precondition: the body is a box, and the dimension has the axis.
std::vector<SurfacePoint> edge_points(const Model& model, const Body& body, Edge edge);

/// Rows of particles that may still be looked at to find carriers; < 0: the search was given up.
struct SearchBudget {
  double rows;
};

/// The same of a polygon: of those of its sides that lie on this side of the box around it.
std::vector<SurfacePoint> polygon_edge_points(const Model& model, const Body& body, Edge edge,
                                              SearchBudget& budget);

/// How many points are tried on a circle, or on a sphere in solid scenes.
double count_rim_points(const Body& body, const Disc& rim, int axes);

/// Points of equal area on the part of a circle (in solid scenes of a sphere) that is a body's surface: body
/// on one side of it, none on the other, and a particle within two spacings.
std::vector<SurfacePoint> rim_points(const Model& model, const Body& body, const Disc& rim, SearchBudget& budget);

}  // namespace trajan
