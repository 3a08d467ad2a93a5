#pragma once

#include "solver/materials/single.h"
#include "solver/schemes/law_particles.h"
#include "solver/transfers/rounding.h"

/// Stages of laws that lose no digits in floats, for particles of floats: twice as many at once as with doubles,
/// and nothing to convert. Only volumes are doubles here too. In a plane with linear elasticity 6.7 -> 2.7 ns per
/// particle and step.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A tensor that a block's particles carry, of whose diagonal so many components are stored.
template <class A, int DiagonalCount>
class FloatTensor {
 public:
  /// `attribute`: of the component at i, j.
  template <class AttributeAt>
  FloatTensor(const Block& b, AttributeAt&& attribute) : rounding_(b, attribute(0, 0)) {
    unroll<DiagonalCount>([&](auto k) { diagonal_[k] = b.component<float>(attribute(k, k)); });
    unroll<A::size>([&](auto i) {
      unroll<A::size>([&](auto j) {
        if constexpr (i != j) off_[A::place(i, j)] = b.component<float>(attribute(i, j));
      });
    });
  }
  A at(int i) const {
    A a{};
    unroll<DiagonalCount>([&](auto k) { a.diagonal[k] = Single(diagonal_[k][i]); });
    unroll<A::off_count>([&](auto k) { a.off[k] = Single(off_[k][i]); });
    return a;
  }
  void add(int i, const A& change) const {
    unroll<DiagonalCount>(
        [&](auto k) { diagonal_[k][i] = rounding_.add(diagonal_[k][i], change.diagonal[k].value, i); });
    unroll<A::off_count>([&](auto k) { off_[k][i] = rounding_.add(off_[k][i], change.off[k].value, i); });
  }

 private:
  float* diagonal_[3];
  float* off_[A::off_count + 1];
  RoundingTo<float> rounding_;  ///< of all components alike
};

template <class Law, Dimension D, bool TotalLagrangian>
struct FloatStages {
  static constexpr int N = grid_axes(D);
  using Stress = SymmetricTensor<N, Single>;
  using Gradient = Tensor<N, Single>;

  static auto stress_of(const Block& block) {
    return FloatTensor < Stress,
           rest_is_free(D) ? N : 3 > (block, [](int i, int j) {
                                   return i == j ? after(Attribute::stress_xx, i)
                                                 : after(Attribute::stress_xy, Stress::place(i, j));
                                 });
  }
  /// F - 1
  static auto deformation_of(const Block& block) {
    return FloatTensor<Gradient, N>(block, [](int i, int j) { return deformation_attribute(i, j); });
  }
  static const Law& law_of(const Block& block) { return *static_cast<const Law*>(block.body->law); }
  static LawExchange<float>& scratch_of(const Block& block) {
    return static_cast<LawExchange<float>&>(*block.scratch);
  }
  /// What the velocity gradient makes in the step.
  static Gradient step(const LawExchange<float>& scratch, Single dt, int i) {
    Gradient g{};
    unroll<N * N>([&](auto k) { g(k / N, k % N) = dt * Single(scratch.narrow_gradient[k][i]); });
    return g;
  }

  /// V sigma or V0 P, over the cell size.
  TRAJAN_FLATTEN static void force(Block& block) {
    LawExchange<float>& scratch = scratch_of(block);
    const double q = block.sweep->inverse_cell;
    const auto put = [&](int i, const Gradient& v) {
      unroll<N * N>([&](auto k) { scratch.narrow_force[k][i] = v(k / N, k % N).value; });
    };
    if constexpr (Law::rate_form) {
      const auto stress = stress_of(block);
      const double* volume = block[Attribute::volume];
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) put(i, full(Single(q * volume[i]) * stress.at(i)));
    } else {
      const auto deformation = deformation_of(block);
      const Law law = law_of(block);
      const LawParticles<Law, D> particles(block);
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) {
        const Gradient h = deformation.at(i);
        const Stress v = Single(q * particles.reference_volume(i)) * law.kirchhoff_of_change(h);
        put(i, TotalLagrangian ? product_transposed(full(v), inverse(plus_diagonal(h, 1.0))) : full(v));
      }
    }
  }

  TRAJAN_FLATTEN static void deform(Block& block) {
    LawExchange<float>& scratch = scratch_of(block);
    const Single dt = deformation_time(block);
    std::int32_t inverted = 0;
    if constexpr (Law::rate_form) {
      const auto stress = stress_of(block);
      double* volume = block[Attribute::volume];
      const Law law = law_of(block);
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) {
        const Stress before = stress.at(i);
        Gradient g = step(scratch, dt, i);
        if constexpr (rest_is_free(D)) law.relax(g, RateState<N, Single>{before, 1.0, {}});
        stress.add(i, law.stress_change(g, before));
        const float growth = dilation(g).value;
        volume[i] = fused(volume[i], static_cast<double>(growth), volume[i]);
        inverted |= growth > -1 ? 0 : -1;
      }
    } else {
      const auto deformation = deformation_of(block);
#pragma GCC ivdep
      for (int i = 0; i < block.count; ++i) {
        const Gradient g = step(scratch, dt, i);
        deformation.add(i, TotalLagrangian ? g : g + product(g, deformation.at(i)));
        inverted |= dilation(deformation.at(i)).value > -1 ? 0 : -1;
      }
    }
    scratch.trouble.inverted += inverted != 0;
  }
};

/// Whether particles that are floats are computed in floats by the law.
template <class Law, Dimension D, bool TotalLagrangian>
constexpr bool is_computed_in_floats() {
  using Gradient = Tensor<grid_axes(D), Single>;
  using Stress = SymmetricTensor<grid_axes(D), Single>;
  if constexpr (D == Dimension::axisymmetric)
    return false;
  else if constexpr (Law::rate_form)
    return !TotalLagrangian && requires(const Law& law, const Gradient& g, const Stress& stress) {
      law.stress_change(g, stress);
    };
  else
    return !rest_is_free(D) && requires(const Law& law, const Gradient& h) { law.kirchhoff_of_change(h); };
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
