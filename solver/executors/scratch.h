#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/executors/aligned.h"

namespace trajan {

/// Particles that one call of a stage works on: their intermediate values stay in the first-level cache. Two of
/// them hold a plane's tile of four particles to a cell, and some that have come from other tiles.
inline constexpr int block_size = 144;
/// Stages may write so many entries past the last particle.
inline constexpr int block_padding = 8;

/// A quantity that lives only while a block passes through a chain of stages.
template <class Number>
struct alignas(64) BlockArray {
  Number values[block_size + 2 * block_padding];
  Number* data() { return values; }
  Number& operator[](int i) { return values[i]; }
  const Number& operator[](int i) const { return values[i]; }
};
using BlockDoubles = BlockArray<double>;

/// What a thread has counted among the particles of its blocks: what went wrong with them, at least once for each
/// block, and how often one's nodes differ from those of the one before it.
struct Trouble {
  std::int64_t runs = 0;
  bool left_window = false;  ///< one has: not an error, particles must be sorted into tiles again
  std::int64_t left_domain = 0;
  std::int64_t moved_too_far = 0;
  std::int64_t inverted = 0;
  std::int64_t unsolved = 0;  ///< no stretch was found that frees the rest of its stress
};

/// Of affine transfers, along one axis and in cells: (x_I - x_p) w_I / D of consecutive nodes, and
/// D = sum w_I (x_I - x_p)^2. Where D is zero the first are the limit that keeps angular momentum.
template <class Number>
struct Levers {
  BlockArray<Number> lever[4];
  BlockArray<Number> inertia;
  BlockArray<Number> moment[3];  ///< of a vector's components, per inertia and cell size
};

/// Of particles while their damage grows.
struct GrowingDamage {
  BlockDoubles value;  ///< what damage follows from, and in the end damage itself
  BlockDoubles stiffness, stored_share;
};

/// Working memory of one thread: what laws see of it.
struct alignas(64) Scratch {
  virtual ~Scratch() = default;
  /// Bytes.
  virtual std::size_t memory() const { return sizeof *this; }

  alignas(64) std::int32_t cell[block_size + 2 * block_padding];  ///< index of the stencil's first node
  BlockDoubles gradient[9];    ///< of velocity, row by row: d v_x / d y is the second
  BlockDoubles gradient_rest;  ///< axisymmetric: hoop strain rate, radial velocity over radius
  BlockDoubles force[9];       ///< volume times stress over cell size, row by row
  BlockDoubles virial_rest;    ///< axisymmetric: volume times hoop stress
  BlockDoubles across[2];      ///< strains across plane or bar while a rate law is solved for them
  GrowingDamage damage;
  double deform_share = 1;  ///< of the step's drift by which laws deform
  Trouble trouble;
};

/// What particles do on the grid is in a number type of their own, most laws know doubles alone.
template <class Number>
struct LawExchange : Scratch {
  BlockArray<Number> narrow_gradient[9];
  BlockArray<Number> narrow_force[9];
  std::vector<BlockDoubles> state;  ///< of Block::floats, in the order of BodyConstants::narrow_state
  BlockArray<Number>* gradient_of_grid() { return narrow_gradient; }
  const BlockArray<Number>* force_on_nodes() const { return narrow_force; }
};
template <>
struct LawExchange<double> : Scratch {
  BlockDoubles* gradient_of_grid() { return gradient; }
  const BlockDoubles* force_on_nodes() const { return force; }
};

/// By strip: its first particle, and how many there are; the first of the eight cells that it has lanes for, and a
/// bit for each that has a particle. One more may be written than there can be.
template <int most>
struct StripList {
  int size = 0;
  std::int32_t begin[most + 1], count[most + 1], cell[most + 1], lanes[most + 1];
};

/// All of it.
template <class Number>
struct alignas(64) TransferScratch : LawExchange<Number> {
  /// Where runs of consecutive particles with the same nodes begin and, after the last one, where it ends.
  /// Particles are ordered by their stencils: what is the same for a run is done once. Runs are found before any
  /// is worked on, for a processor that guesses where the next one ends guesses wrong once a run in a body that
  /// drifts.
  std::int32_t run_begin[block_size + 16];
  int runs = 0;  ///< 0: not known, for there are strips
  /// Strips of particles in ever higher cells of a row (`solver/transfers/strips.h`).
  bool by_strips = false;  ///< what is the same for many is done once for a strip, not for a run
  StripList<block_size / 8> full_strips;
  StripList<block_size> sparse_strips;
  BlockArray<Number> place[3];      ///< distance from the stencil's first node, in cells
  BlockArray<Number> weight[3][4];  ///< shape functions along each axis, of consecutive nodes
  BlockArray<Number> slope[3][4];   ///< their derivatives, per cell
  BlockArray<Number> mass;          ///< of particles, where strips need it because it is not all the same
  BlockArray<Number> acceleration[3];
  BlockArray<Number> velocity[3];
  BlockArray<Number> load[3];          ///< acceleration by loads
  AlignedArray<Number> window;         ///< what the nodes around hold, one array of window_nodes per quantity
  AlignedArray<Number> stencils;       ///< weights that are no products, if the shape functions need them
  std::vector<Levers<Number>> levers;  ///< by axis, if the transfer is affine

  /// Makes room: numbers of a window, of stencils, and axes along which transfers are affine.
  void prepare(std::size_t window_size, std::size_t stencil_size, std::size_t affine_axes) {
    window.resize(window_size);
    stencils.resize(stencil_size);
    levers.resize(affine_axes);
  }
  std::size_t memory() const override {
    return sizeof *this + (window.capacity() + stencils.capacity()) * sizeof(Number) +
           levers.capacity() * sizeof(Levers<Number>);
  }
};

}  // namespace trajan
