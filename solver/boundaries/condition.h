#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/model/model.h"

/// The seam of boundary conditions. A condition is called once per tile or once per kick, never per particle
/// or node.
namespace trajan {

/// The nodes of one tile of the background grid and what they hold: one array of `count` doubles per
/// quantity, the mass and then vectors.
struct TileNodes {
  static constexpr int count = 64;
  int dimensions = 2;
  std::array<std::int64_t, 3> first{};  ///< grid indices of the first node
  double* values = nullptr;

  int bits() const { return 6 / dimensions; }
  /// Grid index of a node along an axis.
  std::int64_t index(int node, int axis) const {
    return axis < dimensions ? first[axis] + ((node >> (bits() * axis)) & ((1 << bits()) - 1)) : 0;
  }
  double* mass() const { return values; }
  double* acceleration(int axis) const { return component(0, axis); }
  double* velocity(int axis) const { return component(1, axis); }
  double* mapped_velocity(int axis) const { return component(2, axis); }

 private:
  double* component(int vector, int axis) const {
    return values + std::ptrdiff_t{1 + vector * dimensions + axis} * count;
  }
};

/// Where nodes are: node (i, j, k) at origin + cell * (i, j, k).
struct GridFrame {
  explicit GridFrame(const Model& model);
  int dimensions;
  Vector origin;
  double cell;
  /// Cells after which the grid repeats itself along an axis; 0: it does not.
  std::array<std::int64_t, 3> period{};
  Vector place(std::int64_t i, std::int64_t j, std::int64_t k) const {
    return {origin.x + cell * static_cast<double>(i), origin.y + cell * static_cast<double>(j),
            origin.z + cell * static_cast<double>(k)};
  }
  Vector place(const TileNodes& tile, int node) const {
    return place(tile.index(node, 0), tile.index(node, 1), tile.index(node, 2));
  }
};

/// When a kick happens: velocities go from `before` to `after`, positions are those of `time` and then go on
/// by `drift`.
struct Kick {
  double time = 0, before = 0, after = 0, drift = 0;
  double length() const { return after - before; }
};

/// What the forces of a condition do in a kick: the energy that they bring in by work, that they consume, and
/// their impulse on the bodies.
struct Reaction {
  double work = 0, dissipated = 0;
  std::array<double, 3> impulse{};
  Reaction& operator+=(const Reaction& other) {
    work += other.work;
    dissipated += other.dissipated;
    for (std::size_t axis = 0; axis < impulse.size(); ++axis) impulse[axis] += other.impulse[axis];
    return *this;
  }
};

/// Bits of the components that are prescribed, by tile and node.
using HeldComponents = std::vector<std::uint8_t>;

/// Collects what conditions say about the displacements of a step.
class DisplacementConstraints {
 public:
  virtual ~DisplacementConstraints() = default;
  /// A component of a node's displacement, by a condition of this index in the model.
  virtual void prescribe(std::size_t condition, std::size_t tile, int node, int axis, double displacement) = 0;
};

class BodyGaps;

class Condition {
 public:
  virtual ~Condition() = default;
  /// Whether its reactions can do work or consume energy.
  virtual bool works() const = 0;
  /// Finds the nodes of these tiles that are concerned, and marks those components that it prescribes.
  virtual void bind(std::span<const TileNodes> tiles, HeldComponents& held) = 0;
  /// From now on gaps between bodies and rigid surfaces count.
  virtual void measure_gaps_by(const BodyGaps&) {}
  /// Prepares for a kick. Throws FormulaNotFinite.
  virtual void prepare(const Kick& kick) = 0;
  /// Changes accelerations and velocities after the kick of a tile's nodes, each as if the other were. Adds to
  /// the reactions, which are those of all conditions in the order of the model.
  virtual void act(std::size_t tile, const TileNodes& nodes, std::span<Reaction> reactions) = 0;
  /// Makes the velocities fit that were mapped a second time.
  virtual void act_on_mapped(std::size_t tile, const TileNodes& nodes) const = 0;
  /// What displacements between two times must be, if that is all that the condition asks for. Throws
  /// FormulaNotFinite.
  virtual void constrain(double, double, DisplacementConstraints&) const {}
};

}  // namespace trajan
