#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "solver/boundaries/condition.h"
#include "solver/simulation/force_balance.h"

namespace trajan {

/// What loads, conditions and damping do to the nodes, collected by tile and added up in an order that does not
/// depend on the number of threads.
class Account {
 public:
  explicit Account(std::size_t conditions) : reactions_(conditions) {}

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
      if (kind < reactions_.size()) reactions_[kind] += sum;
    }
  }
  void add(double work, double dissipated) { work_ += work, dissipated_ += dissipated; }

  double work() const { return work_; }
  double dissipated() const { return dissipated_; }
  /// What boundary conditions have done since these were last forgotten, in the order of the model.
  std::span<const Reaction> reactions() const { return reactions_; }
  std::span<Reaction> reactions() { return reactions_; }
  void forget_reactions() { reactions_.assign(reactions_.size(), {}); }
  /// Of the last kick.
  const ForceBalance& balance() const { return balance_; }
  void restore(double work, double dissipated) { work_ = work, dissipated_ = dissipated; }
  void restore(std::vector<Reaction> reactions) { reactions_ = std::move(reactions); }

 private:
  std::size_t kinds() const { return reactions_.size() + 1; }

  std::vector<Reaction> of_tiles_;
  std::vector<Reaction> reactions_;  ///< by condition
  std::vector<ForceBalance> balances_;
  ForceBalance balance_;
  bool watched_ = false;
  double work_ = 0, dissipated_ = 0;
};

}  // namespace trajan
