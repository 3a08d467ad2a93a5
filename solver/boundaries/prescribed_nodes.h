#pragma once

#include "solver/boundaries/condition.h"
#include "solver/model/model.h"

namespace trajan {

/// The rate at time t of a displacement that is known from 0 to `end`, from a difference over about twice
/// `step`.
double rate_of(const Formula& displacement, Vector at, double t, double step, double end);

/// Velocities before and after kicks that a prescribed motion asks for.
class PrescribedVelocities {
 public:
  explicit PrescribedVelocities(const Model& model);
  struct Value {
    double after = 0, acceleration = 0;
  };
  /// Of a velocity or, if it is one, of a displacement: then positions are exact at the ends of steps.
  Value of(const Formula& formula, bool displacement, Vector at, const Kick& kick) const;

 private:
  double end_, step_;
};

/// All prescribed motions of a model. Momentum and acceleration are both prescribed, so that nothing that
/// particles gather from such a node could have come from elsewhere.
class PrescribedNodes : public Condition {
 public:
  static void make(const Model& model, std::vector<std::unique_ptr<Condition>>& conditions);
  explicit PrescribedNodes(const Model& model);
  bool works() const override { return works_; }
  void bind(std::span<const TileNodes> tiles, HeldComponents& held) override;
  void prepare(const Kick& kick) override;
  void act(std::size_t tile, const TileNodes& nodes, std::span<Reaction> reactions) override;
  void act_on_mapped(std::size_t tile, const TileNodes& nodes) const override;
  void constrain(double from, double to, DisplacementConstraints& constraints) const override;

 private:
  /// A motion's component, at a node where its formula depends on place.
  struct Target {
    std::size_t condition = 0;  ///< index into Model::conditions
    const Formula* formula = nullptr;
    bool displacement = false;
    Vector at;
    PrescribedVelocities::Value value;
  };
  /// One component of one node.
  struct Entry {
    std::uint32_t target;
    std::uint8_t axis;
    std::uint8_t node;
  };
  void bind_node(const TileNodes& tile, int node, std::uint8_t& held);
  std::span<const Entry> entries_of(std::size_t tile) const {
    return {entries_.data() + first_[tile], entries_.data() + first_[tile + 1]};
  }

  GridFrame frame_;
  PrescribedVelocities velocities_;
  std::vector<const PrescribedMotion*> motions_;
  std::vector<std::size_t> conditions_;  ///< by motion, index into Model::conditions
  std::vector<Target> targets_;          ///< by motion and axis, then by node
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> first_;  ///< by tile, and the end
  Kick kick_;
  bool works_ = false;
};

}  // namespace trajan
