#include "solver/contact/impulses.h"

#include <algorithm>
#include <cmath>

namespace trajan {
namespace {

/// Where three and more bodies meet; a hundred rounds leave them thousandths off at worst.
constexpr int most_exchanges = 100;
/// Of the largest impulse: rounding.
constexpr double least_change = 1e-14;
/// A normal that has lost more than this to components that are prescribed has no direction.
constexpr double least_normal = 1e-6;

/// What the impulse of a contact must be, given what it would have to be to stop all relative motion. Whether that
/// is what it is in the tangential direction.
bool limit(Components& impulse, const NodeContact& contact, double mass, unsigned held) {
  if (contact.bonded) return true;
  Components normal = contact.normal;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (held >> axis & 1u) normal[axis] = 0;
  const double length = std::sqrt(dot(normal, normal));
  const double push =
      length > least_normal ? std::max(0.0, (dot(impulse, normal) - mass * contact.approach) / length) : 0;
  if (push == 0) {
    impulse = {};
    return false;
  }
  Components along;
  for (double& component : normal) component /= length;
  const double across = dot(impulse, normal);
  for (std::size_t axis = 0; axis < 3; ++axis) along[axis] = impulse[axis] - across * normal[axis];
  const double sliding = std::sqrt(dot(along, along)), most = contact.friction * push;
  const bool sticks = sliding <= most;
  const double share = sticks ? 1 : most / sliding;
  for (std::size_t axis = 0; axis < 3; ++axis) impulse[axis] = push * normal[axis] + share * along[axis];
  return sticks && contact.friction > 0;
}

}  // namespace

void exchange_impulses(std::span<NodeContact> contacts, std::span<NodeMotion> fields, unsigned held) {
  for (NodeContact& contact : contacts) contact.impulse = {};
  for (int round = 0; round < (contacts.size() > 1 ? most_exchanges : 1); ++round) {
    double largest = 0, change = 0;
    for (NodeContact& contact : contacts) {
      NodeMotion &a = fields[contact.first], &b = fields[contact.second];
      const double mass = a.mass * b.mass / (a.mass + b.mass);
      Components impulse{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(held >> axis & 1u))
          impulse[axis] = contact.impulse[axis] + mass * (a.velocity[axis] - b.velocity[axis]);
      contact.sticks = limit(impulse, contact, mass, held);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double more = impulse[axis] - contact.impulse[axis];
        a.velocity[axis] -= more / a.mass;
        b.velocity[axis] += more / b.mass;
        largest = std::max(largest, std::abs(impulse[axis]));
        change = std::max(change, std::abs(more));
      }
      contact.impulse = impulse;
    }
    if (change <= least_change * largest) break;
  }
}

}  // namespace trajan
