#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "solver/executors/block.h"
#include "solver/executors/instruction_set.h"
#include "solver/scene/scene.h"

namespace trajan {

/// Sums and maxima over particles.
struct Totals {
  double kinetic_energy = 0, strain_energy = 0;
  double momentum_x = 0, momentum_y = 0;
  double squared_speed = 0;       ///< largest
  double squared_wave_speed = 0;  ///< largest, in a total Lagrangian scheme of the reference configuration
};

/// Takes a block into account.
using Measurement = void (*)(const Block&, Totals&);

/// What a constitutive law does, compiled for one dimension and one configuration.
struct LawKernels {
  std::unique_ptr<const void, void (*)(const void*)> (*make)(const double* parameters, Dimension dimension);
  bool rate_form;
  Stage force;   ///< state of the particles -> scratch.force
  Stage deform;  ///< scratch.gradient, sweep.drift -> state of the particles
  /// Cauchy stress of the block into four arrays xx, yy, xy, zz.
  void (*stress)(const Block&, double* const* out);
  Measurement measure;  ///< strain energy and wave speed
};

/// What all windows together have collected for a tile's nodes. Loads stay zero if there are none.
struct NodeSums {
  alignas(64) double values[sum_count][tile_nodes] = {};
};

/// A tile's nodes, what its window and those of its eight neighbours have collected, and the constants of
/// the pass.
struct NodeBlock {
  double* nodes = nullptr;              ///< node_value_count arrays of tile_nodes
  std::array<const double*, 9> sums{};  ///< of the 3 x 3 tiles around, row by row
  int sum_arrays = 0;                   ///< how many of `Sum` there are
  double kick = 0;                      ///< time by which velocities advance
  double damping = 0;                   ///< force per momentum
  double least_mass = 0;                ///< nodes with less do not move
  double light_mass = 0;                ///< nodes with less are spared internal forces in gradients
  NodeSums* collected = nullptr;        ///< working memory
  double work = 0, dissipated = 0;      ///< results
};

/// Everything whose speed depends on the instruction set.
struct Kernels {
  const char* instruction_set;
  Stage locate;
  Stage scatter_state, scatter_state_and_loads, scatter_momentum;
  Stage gather_acceleration, gather_acceleration_and_velocity;
  Stage gather_motion;
  Stage kick, kick_and_blend;
  Stage move, displace;
  Measurement measure_motion;  ///< kinetic energy, momentum and speed
  void (*update_velocities)(NodeBlock&);
  void (*account)(NodeBlock&);
  void (*map_velocities)(NodeBlock&);
  void (*calm_light_nodes)(NodeBlock&);
  /// Copies what a tile and its neighbours hold into a window. `mask`: bits of NodeValue.
  void (*load_window)(Window&, const std::array<const double*, 9>& nodes, unsigned mask);
  const LawKernels* (*law)(std::string_view name, Dimension dimension, bool total_lagrangian);
};

/// The fastest kernels that this processor can run.
const Kernels& kernels();

}  // namespace trajan
