#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

/// What rigid planes and balls have in common.
RigidObstacle Validator::check_contact(const std::string& path, const Contact& contact) {
  RigidObstacle obstacle;
  violations_.not_negative(path + ".friction", contact.friction);
  if (contact.bonded && contact.friction > 0)
    violations_.add(path + ".friction", number_text(contact.friction), "what is bonded does not slide",
                    "leave out friction or bonded");
  // Nodes that are held swing between push and pull from step to step: a block slid a third of its way.
  if (contact.no_separation && contact.friction > 0)
    violations_.add(path + ".friction", number_text(contact.friction),
                    "what is held is pushed and pulled by turns, and friction would count the pushes alone",
                    "leave out friction or no_separation");
  obstacle.friction = contact.friction;
  obstacle.bonded = contact.bonded;
  obstacle.separates = !contact.no_separation;
  obstacle.displacement = motion_formulas(path + ".displacement", contact.displacement);
  return obstacle;
}

RigidObstacle Validator::check_plane(const std::string& path, const RigidPlane& plane) {
  RigidObstacle obstacle = check_contact(path + ".contact", plane.contact);
  const bool point = check_vector(path + ".point", plane.point);
  const bool normal = check_vector(path + ".normal", plane.normal);
  const double length = std::hypot(plane.normal.x, plane.normal.y, plane.normal.z);
  if (point && normal && !(length > 0 && std::isfinite(length)))
    violations_.add(path + ".normal", point_text(plane.normal, axes()), "has no direction",
                    "give the direction out of the rigid half-space, for example { y: 1 }");
  const double components[] = {plane.normal.x, plane.normal.y, plane.normal.z};
  for (int axis = 0; axis < axes(); ++axis)
    if (is_periodic(axis) && components[axis] != 0)
      violations_.add(path + ".normal." + axis_names[static_cast<std::size_t>(axis)],
                      number_text(components[axis]),
                      "the domain repeats itself along this axis and has no half-space across it",
                      "give 0, or leave out the periodic condition");
  obstacle.point = plane.point;
  obstacle.normal = {plane.normal.x / length, plane.normal.y / length, plane.normal.z / length};
  return obstacle;
}

RigidObstacle Validator::check_ball(const std::string& path, const RigidBall& ball) {
  RigidObstacle obstacle = check_contact(path + ".contact", ball.contact);
  check_vector(path + ".centre", ball.centre);
  violations_.positive(path + ".radius", ball.radius);
  if (axes() == 1) violations_.add(path, "", "a bar has no room for a ball", "give a rigid_plane");
  if (model_.dimension == Dimension::axisymmetric && ball.centre.x != 0)
    violations_.add(path + ".centre.x", number_text(ball.centre.x),
                    "away from the axis this is no ball but a ring", "give 0");
  obstacle.point = ball.centre;
  obstacle.radius = ball.radius;
  obstacle.ball = true;
  return obstacle;
}

}  // namespace trajan
