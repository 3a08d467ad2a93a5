#pragma once

#include <array>
#include <cstdint>

#include "solver/executors/attribute.h"
#include "solver/executors/layout.h"

namespace trajan {

/// Particles that one call of a stage works on: their intermediate values stay in the first-level cache.
inline constexpr int block_size = 128;
/// Stages may write so many entries past the last particle.
inline constexpr int block_padding = 4;

/// A quantity that lives only while a block passes through a chain of stages.
struct alignas(64) BlockArray {
  double values[block_size + 2 * block_padding];
  double* data() { return values; }
  double& operator[](int i) { return values[i]; }
};

/// What a thread has counted among the particles of its blocks: what went wrong with them, and how often one's
/// nodes differ from those of the one before it.
struct Trouble {
  std::int64_t runs = 0;
  std::int64_t left_window = 0;  ///< not an error: particles must be sorted into tiles again
  std::int64_t left_domain = 0;
  std::int64_t moved_too_far = 0;
  std::int64_t inverted = 0;
  std::int64_t unsolved = 0;  ///< no stretch was found that frees the rest of its stress
};

/// Of affine transfers, along one axis and in cells: (x_I - x_p) w_I / D of consecutive nodes, and
/// D = sum w_I (x_I - x_p)^2. Where D is zero the first are the limit that keeps angular momentum.
struct Levers {
  BlockArray lever[4];
  BlockArray inertia;
};

/// Working memory of one thread.
struct alignas(64) Scratch {
  alignas(64) std::int64_t cell[block_size + 2 * block_padding];  ///< index of the stencil's first node
  BlockArray place[3];      ///< distance from the stencil's first node, in cells
  BlockArray weight[3][4];  ///< shape functions along each axis, of consecutive nodes
  BlockArray slope[3][4];   ///< their derivatives, per cell
  BlockArray acceleration[3];
  BlockArray velocity[3];
  BlockArray gradient[9];      ///< of velocity, row by row: d v_x / d y is the second
  BlockArray gradient_rest;    ///< axisymmetric: hoop strain rate, radial velocity over radius
  BlockArray force[9];         ///< volume times stress over cell size, row by row
  BlockArray virial_rest;      ///< axisymmetric: volume times hoop stress
  BlockArray across[2];        ///< strains across plane or bar while a rate law is solved for them
  BlockArray load[3];          ///< acceleration by loads
  double deform_share = 1;     ///< of the step's drift by which laws deform
  double* window = nullptr;    ///< what the nodes around hold, one array of window_nodes per quantity
  double* stencils = nullptr;  ///< weights that are no products, if the shape functions need them
  Levers* levers = nullptr;    ///< by axis, if the transfer is affine
  Trouble trouble;
};

/// What all particles of a body share.
struct BodyConstants {
  double density = 0;
  double mass = 0;              ///< of one particle; not of axisymmetric ones
  double reference_volume = 0;  ///< of one particle, thickness included; axisymmetric: area
  double acceleration[3] = {};  ///< by body loads at the present time
  double half_size[3] = {};     ///< of a particle at rest, in cells
  const void* law = nullptr;    ///< the body's law object
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
};

/// Up to block_size particles of one body in one tile.
struct Block {
  int count = 0;
  std::array<double*, attribute_count> arrays{};  ///< from the block's first particle on
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
  double mass(int i) const {
    const double* volumes = (*this)[Attribute::reference_volume];
    return volumes ? body->density * volumes[i] : body->mass;
  }
};

/// One thing that is done to a block. Does not allocate, throw or look anything up.
using Stage = void (*)(Block&);

}  // namespace trajan
