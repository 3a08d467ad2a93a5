#pragma once

#include <array>
#include <optional>
#include <vector>

#include "solver/recorder.h"
#include "solver/simulation/executor.h"

namespace trajan {

/// Watches the angular momentum of bodies on which nothing from outside exerts a torque. Lumped masses do not keep
/// it (Burgess, Sulsky and Brackbill 1992; Love and Sulsky 2006): what spins slows down and shakes instead, while
/// its energy may stay what it was. Transfers that carry an affine velocity keep it (Jiang, Schroeder and Teran
/// 2017) and are left alone.
class AngularMomentum {
 public:
  using Vector3 = std::array<double, 3>;
  AngularMomentum(const Model& model, const Executor& executor);

  /// To be called at samples, from sample 0 on. `internal_energy`: what is in strains and relative motion. What is
  /// wrong is found once.
  std::optional<Warning> check(std::int64_t step, double time, double internal_energy);

  /// \name For checkpoints
  /// @{
  std::vector<double> save() const { return {initial_[0], initial_[1], initial_[2], largest_energy_}; }
  void restore(const std::vector<double>& s) { initial_ = {s[0], s[1], s[2]}, largest_energy_ = s[3]; }
  /// @}

 private:
  struct Moments {
    Vector3 momentum{};  ///< angular, about the common centre of mass
    double inertia = 0;  ///< polar, of each body about its own centre of mass
  };
  Moments moments() const;

  const Model& model_;
  const Executor& executor_;
  bool watched_;
  Vector3 initial_{};
  double largest_energy_ = 0;
};

}  // namespace trajan
