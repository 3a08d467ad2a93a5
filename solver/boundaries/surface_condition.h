#pragma once

#include <memory>
#include <span>

#include "solver/boundaries/condition.h"
#include "solver/surfaces/riders.h"

namespace trajan {

/// A scalar quantity of the grid's velocity: the mean along one axis over a part of a surface, sum of c_I v_I
/// with weights c_I that sum up to 1. An impulse along it goes to the nodes with the same weights, which
/// is what a uniform traction on that part does, and does the same work.
struct SurfaceMean {
  std::uint32_t begin = 0, end = 0;  ///< of the nodes concerned
  double area = 0;
};

struct SurfaceNode {
  std::uint32_t tile = 0;
  std::uint32_t node = 0;
  double weight = 0;
};

/// Collects what conditions on surfaces say about the displacements of a step.
class MeanConstraints {
 public:
  virtual ~MeanConstraints() = default;
  /// The sum of the nodes' displacements along an axis times their weights, by a condition of this index in the
  /// model.
  virtual void prescribe_mean(std::size_t condition, std::span<const SurfaceNode> nodes, int axis,
                              double displacement) = 0;
};

/// A condition on surface points, which knows the nodes around them. `act` and `act_on_mapped` are called
/// once, after all tiles are done; what other conditions prescribe stays.
class SurfaceCondition {
 public:
  /// `condition`: index into Model::conditions. `mean`: one mean over all points; otherwise one per line of grid
  /// nodes along the normal axis that meets the surface, which together say what every point of it does.
  SurfaceCondition(const Model& model, std::size_t condition, const std::vector<SurfacePoint>& points, int normal,
                   bool mean);
  virtual ~SurfaceCondition() = default;
  virtual bool works() const = 0;
  virtual void prepare(const Kick& kick) = 0;
  virtual Reaction act(Tiles& tiles, const HeldComponents& held) = 0;
  virtual void act_on_mapped(Tiles& tiles, const HeldComponents& held) const = 0;
  virtual void advect(const Tiles& tiles, const std::vector<BodyParticles>& bodies, double drift);
  /// What displacements between two times must be, if that is all that the condition asks for; after
  /// `find_nodes`. Throws FormulaNotFinite.
  virtual void constrain(double, double, MeanConstraints&) const {}

  void bind(const std::vector<BodyParticles>& bodies, const Tiles& tiles);
  /// Finds the nodes; to be called before `act` when the points or the particles have moved.
  void find_nodes(const std::vector<BodyParticles>& bodies, const Tiles& tiles);
  Riders& riders() { return riders_; }
  std::size_t condition() const { return condition_; }

 protected:
  /// A component of the velocity (or of what the nodes hold as `vector`) in the mean, and its inverse mass:
  /// how much an impulse changes it.
  struct Mean {
    double velocity = 0, inverse_mass = 0;
  };
  Mean mean(const Tiles& tiles, const HeldComponents& held, const SurfaceMean& of, NodeVector vector,
            int axis) const;
  /// What an impulse has done: how much of it went to nodes that are free, and its work on them.
  struct Pushed {
    double impulse = 0, work = 0;
  };
  /// Adds an impulse along an axis to accelerations and velocities.
  Pushed push(Tiles& tiles, const HeldComponents& held, const SurfaceMean& to, int axis, double impulse,
              double kick) const;
  /// Changes what the nodes hold as `vector` so that its mean along an axis is a value. What was added is the
  /// mean's impulse, or force, and 0 if nothing can move.
  double give(Tiles& tiles, const HeldComponents& held, const SurfaceMean& to, NodeVector vector, int axis,
              double value) const;
  /// What an impulse has done that is in accelerations and velocities already.
  Pushed account(const Tiles& tiles, const HeldComponents& held, const SurfaceMean& to, int axis, double impulse,
                 double kick) const;

  std::span<const SurfaceNode> nodes_of(const SurfaceMean& mean) const {
    return {nodes_.data() + mean.begin, nodes_.data() + mean.end};
  }

  int axes_;  ///< of the grid
  Riders riders_;
  std::vector<SurfaceMean> means_;

 private:
  struct Share {
    std::int64_t line;
    SurfaceNode node;
  };
  void share(const Tiles& tiles, const Riders::Stencil& stencil, double area);
  void collect();
  double inverse_mass(const Tiles& tiles, const HeldComponents& held, const SurfaceNode& at, int axis) const;
  void add(Tiles& tiles, const HeldComponents& held, const SurfaceMean& to, NodeVector vector, int axis,
           double impulse) const;

  std::size_t condition_;
  int normal_;
  bool mean_;
  std::vector<Share> shares_;
  std::vector<SurfaceNode> nodes_;
};

}  // namespace trajan
