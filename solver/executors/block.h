#pragma once

#include <array>
#include <cstdint>

#include "solver/executors/layout.h"

namespace trajan {

/// What a particle may carry, one array each. Only what a scene's kernels need is allocated.
enum class Attribute : std::uint8_t {
  position_x,  ///< where shape functions are evaluated: current, in total Lagrangian schemes reference
  position_y,
  position_z,
  velocity_x,
  velocity_y,
  velocity_z,
  displacement_x,  ///< total Lagrangian schemes: current minus reference position
  displacement_y,
  displacement_z,
  volume,     ///< current, thickness included, in axisymmetric scenes per radian
  stress_xx,  ///< Cauchy
  stress_yy,
  stress_zz,
  stress_xy,
  stress_yz,
  stress_xz,
  deformation_xx,  ///< deformation gradient F
  deformation_xy,
  deformation_xz,
  deformation_yx,
  deformation_yy,
  deformation_yz,
  deformation_zx,
  deformation_zy,
  deformation_zz,
  affine_xx,  ///< APIC: sum of velocity times distance from the particle
  affine_xy,
  affine_xz,
  affine_yx,
  affine_yy,
  affine_yz,
  affine_zx,
  affine_zy,
  affine_zz,
  history_0,  ///< what the law itself remembers, in the order that it states
  history_1,
  history_2,
  history_3,
  history_4,
  history_5,
  history_6,
  history_7,
  reference_volume,  ///< only where a body's particles differ in it: axisymmetric, per radian
  load_x,            ///< acceleration by loads that differ from particle to particle
  load_y,
  load_z,
  count
};
inline constexpr int most_history_variables = 8;
inline constexpr int attribute_count = static_cast<int>(Attribute::count);

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

/// What went wrong with particles of a thread's blocks, as counts.
struct Trouble {
  std::int64_t left_window = 0;  ///< not an error: particles must be sorted into tiles again
  std::int64_t left_domain = 0;
  std::int64_t moved_too_far = 0;
  std::int64_t inverted = 0;
  std::int64_t unsolved = 0;  ///< no stretch was found that frees the rest of its stress
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
