#pragma once

#include <algorithm>

#include "solver/schemes/finite_law_step.h"
#include "solver/schemes/law_response.h"
#include "solver/schemes/rate_law_step.h"

/// Responses of blocks to a finite step, by a law written for one point: derivatives by dual numbers. What they
/// cost is little beside the factorization of what is assembled from them, so that they are compiled once, for no
/// particular instruction set and without flattening.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Law, Dimension D, bool TotalLagrangian>
class LawResponder {
  static constexpr int N = grid_axes(D);
  static constexpr int components = N * N + (D == Dimension::axisymmetric ? 1 : 0);
  static constexpr int free_count = rest_is_free(D) ? 3 - N : 0;
  static constexpr int variables = components + free_count;
  using Particles = LawParticles<Law, D, true>;
  using Step = std::conditional_t<Law::rate_form, RateLawStep<Law, D, TotalLagrangian>,
                                  FiniteLawStep<Law, D, TotalLagrangian>>;
  using Variable = Dual<variables>;

 public:
  static void respond(const Block& block, double dt, LawResponse& response) {
    const Particles particles(block);
    for (int i = 0; i < block.count; ++i) {
      const Step step(law(block), particles, i, dt);
      Tensor<N> g = gradient(response.gradient, i);
      bool inverted = !(step.volume_ratio(g) > 0);
      if constexpr (free_count > 0) {
        response.unsolved += !step.free_rest(g);
        inverted |= !(step.volume_ratio(g) > 0);
      }
      response.inverted += inverted;
      double* const force = response.force + i * components;
      if (response.tangent)
        differentiate(step, g, particles.reference_volume(i), force,
                      response.tangent + i * components * components);
      else
        pull(step, g, particles.reference_volume(i), force);
    }
  }

  static void commit(Block& block, double dt, const double* gradients) {
    const Particles particles(block);
    for (int i = 0; i < block.count; ++i) {
      const Step step(law(block), particles, i, dt);
      Tensor<N> g = gradient(gradients, i);
      if constexpr (free_count > 0) step.free_rest(g);
      step.commit(particles, i, g);
    }
  }

  static const LawResponseKernels* kernels() {
    static constexpr LawResponseKernels table{components, is_geometrically_linear<Law>(), &respond, &commit};
    return &table;
  }

 private:
  /// The law object is made by the same class, if perhaps compiled for another instruction set.
  static const Law& law(const Block& block) { return *static_cast<const Law*>(block.body->law); }

  /// The components of G in their order, the free rest after them.
  template <class T>
  static T& component(Tensor<N, T>& g, int c) {
    return c < N * N ? g(c / N, c % N) : g.diagonal[N + c - N * N];
  }
  static Tensor<N> gradient(const double* gradients, int i) {
    Tensor<N> g{};
    for (int c = 0; c < components; ++c) component(g, c) = gradients[i * components + c];
    return g;
  }

  static void pull(const Step& step, const Tensor<N>& g, double volume, double* force) {
    Tensor<N> nominal = step.nominal(step.kirchhoff(g), g);
    for (int c = 0; c < components; ++c) force[c] = volume * component(nominal, c);
  }

  static void differentiate(const Step& step, const Tensor<N>& at, double volume, double* force, double* tangent) {
    Tensor<N, Variable> g = cast<Variable>(at);
    for (int c = 0; c < variables; ++c) component(g, c).slope[c] = 1;
    const SymmetricTensor<N, Variable> kirchhoff = step.kirchhoff(g);
    Tensor<N, Variable> nominal = step.nominal(kirchhoff, g);
    std::array<Variable, variables> rows;
    for (int c = 0; c < components; ++c) rows[c] = component(nominal, c);
    for (int k = 0; k < free_count; ++k) rows[components + k] = kirchhoff.diagonal[N + k];
    release(rows);
    for (int c = 0; c < components; ++c) {
      force[c] = volume * rows[c].value;
      for (int d = 0; d < components; ++d) tangent[c * components + d] = volume * rows[c].slope[d];
    }
  }

  /// Eliminates the free rest, whose stresses stay what they are: zero.
  static void release(std::array<Variable, variables>& rows) {
    for (int r = variables - 1; r >= components; --r) {
      const double q = 1 / rows[r].slope[r];
      for (int i = 0; i < r; ++i) {
        const double share = rows[i].slope[r] * q;
        for (int j = 0; j < r; ++j) rows[i].slope[j] -= share * rows[r].slope[j];
      }
    }
  }
};

template <class Law>
const LawResponseKernels* response_of(Dimension dimension, bool total_lagrangian) {
  switch (dimension) {
#define TRAJAN_RESPONSE(D)                                                     \
  case Dimension::D:                                                           \
    return total_lagrangian ? LawResponder<Law, Dimension::D, true>::kernels() \
                            : LawResponder<Law, Dimension::D, false>::kernels();
    TRAJAN_RESPONSE(bar)
    TRAJAN_RESPONSE(plane_stress)
    TRAJAN_RESPONSE(plane_strain)
    TRAJAN_RESPONSE(axisymmetric)
    TRAJAN_RESPONSE(solid)
#undef TRAJAN_RESPONSE
    case Dimension::unspecified:
      break;
  }
  return nullptr;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
