#pragma once

#include "solver/materials/wave_modulus.h"
#include "solver/schemes/configuration.h"
#include "solver/schemes/kernels.h"
#include "solver/schemes/law_particles.h"

/// Turns a law, written for one point, into stages over blocks. SIMD is across the particles.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// One stage after the other.
template <Stage... stages>
void in_turn(Block& block) {
  (stages(block), ...);
}

template <class Law, Dimension D>
struct LawStages {
  static constexpr int N = grid_axes(D), history_size = history_count<Law>();
  static constexpr bool free_rest = rest_is_free(D);
  using History = HistoryOf<Law>;
  using State = typename LawParticles<Law, D>::State;

  static const Law& law(const Block& block) { return *static_cast<const Law*>(block.body->law); }

  using Particles = LawParticles<Law, D>;

  /// V sigma, over the cell size but for the hoop.
  TRAJAN_FLATTEN static void force(Block& block) {
    Scratch& scratch = *block.scratch;
    const Particles particles(block);
    const Law material = law(block);
    const double q = block.sweep->inverse_cell;
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      const SymmetricTensor<N> v = particles.virial(material, i);
      unroll<N * N>([&](auto k) { scratch.force[k][i] = q * v(k / N, k % N); });
      if constexpr (D == Dimension::axisymmetric) scratch.virial_rest[i] = v.diagonal[2];
    }
  }

  TRAJAN_FLATTEN static void stress(const Block& block, double* const* out) {
    const Particles particles(block);
    const Law material = law(block);
    for (int i = 0; i < block.count; ++i) {
      SymmetricTensor<N> s;
      if constexpr (Law::rate_form)
        s = cauchy_stress(material, particles.state(i));
      else
        s = (is_geometrically_linear<Law>() ? 1 : 1 / determinant(particles.deformation.at(i))) *
            respond(material, particles.deformation.at(i), particles.history.at(i)).kirchhoff;
      if constexpr (free_rest) unroll<3 - N>([&](auto k) { s.diagonal[N + k] = 0; });
      if constexpr (N == 1) out[0][i] = s(0, 0);
      if constexpr (N == 2) out[0][i] = s(0, 0), out[1][i] = s(1, 1), out[2][i] = s(0, 1), out[3][i] = s(2, 2);
      if constexpr (N == 3) unroll<3>([&](auto k) { out[k][i] = s.diagonal[k], out[3 + k][i] = s.off[k]; });
    }
  }

  template <bool TotalLagrangian>
  TRAJAN_FLATTEN static void measure(const Block& block, Totals& totals) {
    const LawParticles<Law, D, true> particles(block);
    const Law material = law(block);
    double energy = 0, dissipated = 0, fastest = totals.squared_wave_speed;
    for (int i = 0; i < block.count; ++i) {
      double modulus;
      if constexpr (requires(const History& h) { material.dissipated_energy(h); })
        dissipated += particles.reference_volume(i) * material.dissipated_energy(particles.history.at(i));
      if constexpr (Law::rate_form) {
        const State s = particles.state(i);
        if constexpr (requires { material.energy_density(s); })
          energy += particles.volume[i] * material.energy_density(s);
        modulus = particles.volume[i] * material.moduli(s).wave_modulus(D);
        // Waves are as much faster in the reference configuration as it is longer than the current one.
        if constexpr (TotalLagrangian) modulus /= smallest_squared_stretch(particles.deformation.at(i));
      } else {
        const Tensor<N> f = particles.deformation.at(i);
        const History h = particles.history.at(i);
        energy += particles.reference_volume(i) * respond(material, f, h).energy;
        modulus = particles.reference_volume(i) * wave_modulus<D>(material, f, h, TotalLagrangian);
      }
      const double square = modulus / (particles.density * particles.reference_volume(i));
      if (!(square <= fastest)) fastest = square;
    }
    totals.strain_energy += energy;
    totals.dissipated_energy += dissipated;
    totals.squared_wave_speed = fastest;
  }
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
