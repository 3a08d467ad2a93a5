#pragma once

#include <cstdint>
#include <span>

#include "solver/contact/separating_plane.h"

namespace trajan {

/// Two velocity fields that touch at a node.
struct NodeContact {
  std::uint8_t node = 0;
  bool bonded = false;                  ///< never separate, never slide
  bool sticks = false;                  ///< whether it did in the last kick
  std::uint32_t first = 0, second = 0;  ///< which of the fields there
  Components normal{};                  ///< of unit length, out of the first into the second
  double friction = 0;
  double approach = 0;   ///< speed along the normal that is left to them, by which they just touch
  Components impulse{};  ///< on the second, what the first gets is the opposite
};

/// One field at a node.
struct NodeMotion {
  double mass = 0;
  Components velocity{};
};

/// Changes the velocities of the fields at a node by impulses of its contacts, which are equal and opposite, only
/// push until no speed of approach is left but what a contact has to spare, and have tangential parts by Coulomb's
/// law that at most stop the sliding. With more than one contact it goes round until all agree. `held`: bits of
/// the components that are prescribed, which do not change.
void exchange_impulses(std::span<NodeContact> contacts, std::span<NodeMotion> fields, unsigned held);

}  // namespace trajan
