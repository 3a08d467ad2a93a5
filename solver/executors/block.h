#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "solver/executors/attribute.h"
#include "solver/executors/layout.h"
#include "solver/executors/scratch.h"

namespace trajan {

/// What all particles of a body share.
struct BodyConstants {
  double density = 0;
  double mass = 0;                               ///< of one particle; not of axisymmetric ones
  double reference_volume = 0;                   ///< of one particle, thickness included; axisymmetric: area
  double acceleration[3] = {};                   ///< by body loads at the present time
  double half_size[3] = {};                      ///< of a particle at rest, in cells
  const void* law = nullptr;                     ///< the body's law object
  std::span<const Attribute> narrow_state = {};  ///< what particles carry for the law in floats
};

/// What all particles share during a sweep.
struct SweepConstants {
  double cell = 0;
  double inverse_cell = 0;
  double origin[3] = {};                ///< of the grid
  double lower[3] = {}, upper[3] = {};  ///< no particle may leave this box
  double faces[3] = {};                 ///< cells from the lower face of the domain to the upper one
  double period[3] = {};                ///< cells after which the grid repeats itself; 0: it does not
  double kick = 0;                      ///< time by which velocities advance
  double drift = 0;                     ///< time by which positions advance
  double flip = 1;
  std::int64_t step = 0;  ///< what rounding to floats is told apart by
};

/// Up to block_size particles of one body in one tile.
struct Block {
  int count = 0;
  std::array<double*, attribute_count> arrays{};  ///< from the block's first particle on
  std::array<float*, attribute_count> floats{};   ///< likewise: an attribute is one or the other
  const BodyConstants* body = nullptr;
  const SweepConstants* sweep = nullptr;
  double window_first[3] = {};  ///< first cell of the tile's window
  /// Cells of the window in which the particles may be, both ends included.
  double lowest[3] = {}, highest[3] = {};
  double* sums = nullptr;  ///< the tile's, one array of window_nodes per quantity
  Scratch* scratch = nullptr;

  double* operator[](Attribute a) const { return arrays[static_cast<int>(a)]; }
  /// A component of a vector whose first component is `a`.
  double* component(Attribute a, int axis) const { return arrays[static_cast<int>(a) + axis]; }
  /// The same of what particles have in the number type of what they do on the grid.
  template <class Number>
  Number* component(Attribute a, int axis = 0) const;
  double mass(int i) const {
    const double* volumes = (*this)[Attribute::reference_volume];
    return volumes ? body->density * volumes[i] : body->mass;
  }
};

template <>
inline double* Block::component<double>(Attribute a, int axis) const {
  return arrays[static_cast<int>(a) + axis];
}
template <>
inline float* Block::component<float>(Attribute a, int axis) const {
  return floats[static_cast<int>(a) + axis];
}

/// One thing that is done to a block. Does not allocate, throw or look anything up.
using Stage = void (*)(Block&);

}  // namespace trajan
