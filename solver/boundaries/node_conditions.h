#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solver/executors/tiles.h"
#include "solver/model/model.h"

namespace trajan {

/// Prescribed velocities on nodes. Momentum and acceleration are both prescribed, so that nothing that
/// particles gather from such a node could have come from elsewhere.
class NodeConditions {
 public:
  explicit NodeConditions(const Model& model);
  /// Finds the nodes of `tiles` that are concerned.
  void bind(const Tiles& tiles);
  bool none() const { return conditions_.empty(); }
  /// Whether a prescribed velocity can do work.
  bool work() const { return work_; }

  /// Evaluates the velocities before and after a kick of length `kick`.
  void evaluate(double before, double after, double kick);
  /// Overrides acceleration and velocity of a tile's nodes; returns the work of the reactions.
  double prescribe(std::size_t tile, double* nodes, double kick) const;
  /// Overrides the velocities that were mapped a second time.
  void prescribe_mapped(std::size_t tile, double* nodes) const;

 private:
  struct Velocity {
    double after = 0, acceleration = 0;
  };
  /// One component of one node.
  struct Entry {
    std::uint16_t condition;
    std::uint8_t axis;
    std::uint8_t node;
  };
  std::span<const Entry> entries_of(std::size_t tile) const {
    return {entries_.data() + first_[tile], entries_.data() + first_[tile + 1]};
  }

  const Model& model_;
  int axes_;  ///< of the grid
  std::vector<NodeCondition> conditions_;
  std::vector<Velocity> velocities_;  ///< by condition and axis
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> first_;  ///< by tile, and the end
  bool work_ = false;
};

}  // namespace trajan
