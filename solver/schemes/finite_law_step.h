#pragma once

#include "solver/schemes/step_kinematics.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Law, Dimension D, bool TotalLagrangian>
class FiniteLawStep {
 public:
  static constexpr int N = grid_axes(D);
  using Particles = LawParticles<Law, D, true>;

  FiniteLawStep(const Law& law, const Particles& particles, int i, double dt)
      : law_(law), motion_{particles.deformation.at(i)}, history_(particles.history.at(i)), dt_(dt) {}

  /// Finds the rest of `g`; false: there is none.
  bool free_rest(Tensor<N>& g) const {
    Tensor<N> end = motion_.end(g);
    bool solved = false;
    for (int round = 0; !solved && round < most_corrections; ++round)
      solved = correct_rest(law_, history_, dt_, end);
    unroll<3 - N>([&](auto k) {
      const double from = motion_.start.diagonal[N + k], change = end.diagonal[N + k] - from;
      g.diagonal[N + k] = TotalLagrangian ? change : change / from;
    });
    return solved;
  }
  double volume_ratio(const Tensor<N>& g) const { return determinant(motion_.end(g)); }

  /// At the end.
  template <class T>
  SymmetricTensor<N, T> kirchhoff(const Tensor<N, T>& g) const {
    const Tensor<N, T> end = motion_.end(g);
    return respond(law_, end, history_after(end)).kirchhoff;
  }
  template <class T>
  Tensor<N, T> nominal(const SymmetricTensor<N, T>& kirchhoff, const Tensor<N, T>& g) const {
    if constexpr (is_geometrically_linear<Law>())
      return full(kirchhoff);
    else
      return motion_.nominal(kirchhoff, g);
  }

  void commit(const Particles& particles, int i, const Tensor<N>& g) const {
    const Tensor<N> end = motion_.end(g);
    particles.deformation.set(i, end);
    particles.history.set(i, history_after(end));
  }

 private:
  template <class T>
  HistoryOf<Law, T> history_after(const Tensor<N, T>& end) const {
    HistoryOf<Law, T> history{};
    unroll<history_count<Law>()>([&](auto h) { history[h] = T(history_[h]); });
    if constexpr (history_count<Law>() > 0) law_.evolve(end, dt_, history);
    return history;
  }

  const Law& law_;
  StepKinematics<N, TotalLagrangian> motion_;
  HistoryOf<Law> history_;
  double dt_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
