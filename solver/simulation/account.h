#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solver/boundaries/condition.h"
#include "solver/simulation/force_balance.h"

namespace trajan {

/// Energies that have gone into and out of bodies. `contact`: the part of `dissipated` that contact has, between
/// bodies and with rigid ones.
struct Exchanged {
  double work = 0, dissipated = 0, contact = 0;
};

/// What loads, conditions, contacts and damping do to the nodes, collected by tile and added up in an order that
/// does not depend on the number of threads.
class Account {
 public:
  explicit Account(const Model& model)
      : conditions_(model.conditions), reactions_(conditions_.size() + model.outputs.contact_forces.size()) {}

  void bind(std::size_t tiles) {
    of_tiles_.assign(tiles * kinds(), {});
    balances_.assign(watched_ ? tiles : 0, {});
  }
  /// From now on forces on nodes are balanced whenever velocities are updated.
  void watch_forces(std::size_t tiles) {
    watched_ = true;
    balances_.assign(tiles, {});
  }
  bool watched() const { return watched_; }

  /// What happens to a tile's nodes in a kick: of each condition, then of loads and damping together.
  std::span<Reaction> of_tile(std::size_t tile) { return std::span(of_tiles_).subspan(tile * kinds(), kinds()); }
  void forget_tile(std::size_t tile) { std::ranges::fill(of_tile(tile), Reaction{}); }
  ForceBalance& balance_of_tile(std::size_t tile) { return balances_[tile]; }
  /// Ends a kick.
  void add_up() {
    balance_ = {};
    for (const ForceBalance& of_tile : balances_) balance_ += of_tile;
    for (std::size_t kind = 0; kind < kinds(); ++kind) {
      Reaction sum;
      for (std::size_t i = kind; i < of_tiles_.size(); i += kinds()) sum += of_tiles_[i];
      add(sum.work, sum.dissipated);
      if (kind == conditions_.size()) continue;
      reactions_[kind] += sum;
      if (std::holds_alternative<RigidObstacle>(conditions_[kind].kind)) exchanged_.contact += sum.dissipated;
    }
  }
  void add(double work, double dissipated) { exchanged_.work += work, exchanged_.dissipated += dissipated; }
  /// What contact between bodies has dissipated.
  void add_contact(double dissipated) { exchanged_.dissipated += dissipated, exchanged_.contact += dissipated; }
  /// An impulse of contact on a body, by the place of its name in OutputPlan::contact_forces.
  void add_contact(std::size_t body, const std::array<double, 3>& impulse) {
    reactions_[conditions_.size() + body] += {0, 0, impulse};
  }

  const Exchanged& exchanged() const { return exchanged_; }
  /// What boundary conditions, and then contact on bodies whose forces are asked for, have done since these were
  /// last forgotten, in the order of the model.
  std::span<const Reaction> reactions() const { return reactions_; }
  std::span<Reaction> reactions() { return reactions_; }
  void forget_reactions() { reactions_.assign(reactions_.size(), {}); }
  /// Of the last kick.
  const ForceBalance& balance() const { return balance_; }
  void restore(const Exchanged& exchanged) { exchanged_ = exchanged; }
  void restore(std::vector<Reaction> reactions) { reactions_ = std::move(reactions); }

 private:
  std::size_t kinds() const { return conditions_.size() + 1; }

  const std::vector<BoundaryCondition>& conditions_;
  std::vector<Reaction> of_tiles_;
  std::vector<Reaction> reactions_;
  std::vector<ForceBalance> balances_;
  ForceBalance balance_;
  bool watched_ = false;
  Exchanged exchanged_;
};

}  // namespace trajan
