#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"
#include "solver/executors/tiles.h"
#include "solver/scene/scene.h"

namespace trajan {

/// Sums and maxima over particles.
struct Totals {
  double kinetic_energy = 0, strain_energy = 0;
  double dissipated_energy = 0;  ///< so far, by the materials
  double momentum[3] = {};
  double squared_speed = 0;       ///< largest
  double squared_wave_speed = 0;  ///< largest, in a total Lagrangian scheme of the reference configuration
};

/// Takes a block into account.
using Measurement = void (*)(const Block&, Totals&);

/// What a constitutive law does, compiled for one dimension and one configuration.
struct LawKernels {
  /// A law object of these parameters and this density at rest.
  std::unique_ptr<const void, void (*)(const void*)> (*make)(const double* parameters, double density);
  /// What a particle remembers at first, by its number within the body.
  void (*begin)(const void* law, std::uint64_t particle, double* history);
  std::span<const Attribute> attributes;  ///< what particles carry for the law
  int history;                            ///< how many history variables
  bool rate_form;
  Stage force;   ///< state of the particles -> scratch.force, scratch.virial_rest
  Stage deform;  ///< scratch.gradient, scratch.gradient_rest, sweep.drift, scratch.deform_share -> state of the
                 ///< particles
  Stage track;   ///< scratch.gradient, sweep.drift -> deformation gradient; nullptr: the law itself needs it
  std::span<const Attribute> tracked;  ///< what particles carry for that
  /// Cauchy stress of the block into arrays xx (bar), xx, yy, xy, zz (plane, axisymmetric) or
  /// xx, yy, zz, xy, yz, xz (solid).
  void (*stress)(const Block&, double* const* out);
  Measurement measure;  ///< strain energy and wave speed
  /// Of particles that are floats, by a law that is computed in them: scratch's narrow_force and narrow_gradient.
  struct InFloats {
    Stage force = nullptr, deform = nullptr;
  } in_floats;
};

/// What all windows together have collected for a tile's nodes. Loads stay zero if there are none.
struct NodeSums {
  alignas(64) double values[quantities(sum_vectors, 3)][tile_nodes] = {};
};

/// A tile's nodes, what its window and those of its neighbours have collected, and the constants of the pass.
struct NodeBlock {
  double* nodes = nullptr;          ///< one array of tile_nodes per quantity
  Neighbours sums{};                ///< of the tiles around
  int sum_quantities = 0;           ///< how many there are in a window
  double kick = 0;                  ///< time by which velocities advance
  double damping = 0;               ///< force per momentum
  double least_mass = 0;            ///< nodes with less do not move
  double light_mass = 0;            ///< nodes with less are spared internal forces in gradients
  bool collect_mass = false;        ///< where velocities are mapped: mass as well
  NodeSums* collected = nullptr;    ///< working memory
  double work = 0, dissipated = 0;  ///< results
};

/// What affine transfers need: velocities that vary linearly about their particle. Not of all shape functions.
struct AffineKernels {
  Stage find_levers = nullptr;
  Stage locate_values = nullptr;  ///< without slopes, if levers do not need them
  Stage begin = nullptr;          ///< makes of the gradient of initial velocities what particles carry
  /// As of other transfers, with the momentum of velocities that vary.
  Stage scatter_state = nullptr, scatter_momentum = nullptr;
  Stage gather = nullptr;  ///< the grid's velocity, and what particles carry of it
  Stage kick = nullptr;    ///< the grid's acceleration, and what it adds to that
  bool strips = false;     ///< particles should lie in strips
};

/// What depends on the shape functions and the dimension.
struct TransferKernels {
  Layout layout;
  int stencil_size;        ///< numbers that a block needs for weights that are no products
  bool needs_deformation;  ///< particles must know their deformation gradient
  bool strips;             ///< particles should lie in strips
  Stage locate;
  Stage locate_values;  ///< without slopes
  Stage scatter_state;  ///< mass, momentum and internal force
  Stage scatter_hoop;   ///< axisymmetric: the hoop stress's force
  Stage scatter_loads, scatter_mass, scatter_momentum;
  Stage gather_acceleration, gather_velocity, gather_gradient;
  Stage gather_motion;  ///< velocity, and the gradient of the mapped one
  Stage gather_hoop;    ///< axisymmetric: hoop strain rate
  void (*update_velocities)(NodeBlock&);
  void (*map_velocities)(NodeBlock&);
  /// Copies what a tile and its neighbours hold into a window. `mask`: bits of the quantities.
  void (*load_window)(Scratch&, const Neighbours& nodes, unsigned mask);
  AffineKernels affine;
  Stage gather_projected;                    ///< velocity, where it is not the grid's
  Stage remap;                               ///< the nodes' remainder to the particles, and its momentum back
  void (*reduce_remainder)(NodeBlock&);      ///< by what the particles have brought back
  const TransferKernels* general = nullptr;  ///< these are but for FLIP, those are for all transfers
};

/// Between particles that are floats and laws that know doubles alone. None where particles are doubles.
struct LawExchangeKernels {
  Stage widen_state = nullptr;     ///< what particles carry for the law, before it
  Stage widen_gradient = nullptr;  ///< what has been gathered for it
  Stage narrow_state = nullptr;    ///< what particles carry, after it
  Stage narrow_force = nullptr;    ///< what the law has given for the nodes

  void widen(Block& block) const {
    if (widen_state) widen_state(block);
  }
};

/// What depends on the dimension alone.
struct MotionKernels {
  Stage find_loads, kick, kick_and_blend, move, displace;
  Measurement measure;  ///< kinetic energy, momentum and speed
  void (*account)(NodeBlock&);
  void (*calm_light_nodes)(NodeBlock&);
  Stage take_velocity;  ///< that which has been gathered
  Stage own_velocity;   ///< the particle's, as if it had been gathered
  LawExchangeKernels law_exchange;
};

/// What depends on the number type of what particles do on the grid.
struct GridKernels {
  MotionKernels motion[3];  ///< by grid axes, less one
  /// nullptr: there are no shape functions of that name. Some have a margin in any case.
  const TransferKernels* (*transfer)(std::string_view shape_functions, Dimension dimension, Margin margin);
};

/// Everything whose speed depends on the instruction set.
struct Kernels {
  const char* instruction_set;
  const GridKernels &doubles, &floats;
  const LawKernels* (*law)(std::string_view name, Dimension dimension, bool total_lagrangian);
  const GridKernels& grid(const Numerics& numerics) const {
    return numerics.precision == float_precision ? floats : doubles;
  }
};

/// The fastest kernels that this processor can run.
const Kernels& kernels();

}  // namespace trajan
