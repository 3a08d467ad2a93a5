#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "solver/recorder.h"
#include "solver/simulation/executor.h"

namespace trajan {

/// Watches whether shape functions still join the particles of each body. Those that go with the present places of
/// particles lose a body that is stretched too far, without any other sign: what has come apart just flies on.
/// What may break or scatter (damage, fluids) and total Lagrangian schemes, whose particles stay in their cells,
/// are left alone.
class Coherence {
 public:
  Coherence(const Model& model, const Executor& executor);

  /// To be called at samples. Looks for gaps between particles, and for pieces, which takes as long as some steps,
  /// if many have passed or it is `due`. A body that has come apart is found once.
  std::vector<Warning> check(std::int64_t step, double time, bool due);
  /// The step of the sample that a run goes on from.
  void resume(std::int64_t step) { last_sample_ = step; }

 private:
  using Cell = std::uint64_t;
  /// Groups of particles that share nodes, by cells, and a particle of the smallest one.
  struct Groups {
    std::size_t count = 0;
    std::size_t slot = 0;
  };
  bool is_watched(const Body& body) const;
  Cell cell_of(const BodyParticles& body, std::size_t slot) const;
  Groups groups(const BodyParticles& body) const;
  std::optional<Warning> check_gaps(std::size_t body) const;
  std::optional<Warning> check_groups(std::size_t body) const;
  Warning warning(std::size_t body, std::size_t slot, const std::string& cause) const;

  const Model& model_;
  const Executor& executor_;
  int axes_, reach_;
  bool stretches_with_particles_;
  std::vector<std::size_t> groups_at_first_;  ///< by body; 0: it is not watched, or has been found
  std::int64_t last_sample_ = 0;              ///< its step
};

}  // namespace trajan
