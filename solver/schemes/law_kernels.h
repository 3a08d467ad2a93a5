#pragma once

#include <cstdint>

#include "solver/schemes/kernels.h"
#include "solver/schemes/law_state.h"

/// Turns a law, written for one point, into stages over blocks. SIMD is across the particles.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Law, Dimension D, bool TotalLagrangian>
struct LawStages {
  static const Law& law(const Block& block) { return *static_cast<const Law*>(block.body->law); }

  using State = LawState<D>;

  /// Volume times Kirchhoff or Cauchy stress, whichever makes it the particle's virial.
  static SymmetricTensor<double> virial(const Law& law, const State& s, double reference_volume, int i) {
    if constexpr (Law::rate_form) {
      const double v = s.volume[i];
      return {v * s.sxx[i], v * s.syy[i], v * s.sxy[i], 0.0};
    } else {
      const SymmetricTensor<double> t = law.template response<D>(s.deformation(i)).kirchhoff;
      const double v = reference_volume;
      return {v * t.xx, v * t.yy, v * t.xy, 0.0};
    }
  }

  /// In the updated Lagrangian form V sigma / h, in the total one V0 P / h with P F^T = J sigma.
  static void force(Block& block) {
    Scratch& scratch = *block.scratch;
    const State s(block);
    const Law material = law(block);
    const double q = block.sweep->inverse_cell, reference_volume = block.body->reference_volume;
    double *fxx = scratch.force[0].data(), *fxy = scratch.force[1].data();
    double *fyx = scratch.force[2].data(), *fyy = scratch.force[3].data();
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      const SymmetricTensor<double> v = virial(material, s, reference_volume, i);
      if constexpr (TotalLagrangian) {
        const PlaneTensor<double> f = s.deformation(i);
        const double r = q / determinant(f);
        fxx[i] = r * (v.xx * f.yy - v.xy * f.xy);
        fxy[i] = r * (v.xy * f.xx - v.xx * f.yx);
        fyx[i] = r * (v.xy * f.yy - v.yy * f.xy);
        fyy[i] = r * (v.yy * f.xx - v.xy * f.yx);
      } else {
        fxx[i] = q * v.xx;
        fxy[i] = q * v.xy;
        fyx[i] = q * v.xy;
        fyy[i] = q * v.yy;
      }
    }
  }

  /// F' = (1 + dt L) F, or in the total Lagrangian form F' = F + dt Fdot, L = Fdot F^-1.
  static void deform(Block& block) {
    Scratch& scratch = *block.scratch;
    const State s(block);
    const Law material = law(block);
    const double dt = block.scratch->deform_share * block.sweep->drift;
    const double *gxx = scratch.gradient[0].data(), *gxy = scratch.gradient[1].data();
    const double *gyx = scratch.gradient[2].data(), *gyy = scratch.gradient[3].data();
    std::int64_t inverted = 0;
#pragma GCC ivdep
    for (int i = 0; i < block.count; ++i) {
      PlaneTensor<double> g{dt * gxx[i], dt * gxy[i], dt * gyx[i], dt * gyy[i]};
      double j = determinant(PlaneTensor<double>{1 + g.xx, g.xy, g.yx, 1 + g.yy});
      if constexpr (TotalLagrangian || !Law::rate_form) {
        const PlaneTensor<double> f = s.deformation(i);
        const PlaneTensor<double> increment = TotalLagrangian ? g : product(g, f);
        const PlaneTensor<double> next{f.xx + increment.xx, f.xy + increment.xy, f.yx + increment.yx,
                                       f.yy + increment.yy};
        j = determinant(next);
        s.set_deformation(i, next);
        if constexpr (TotalLagrangian && Law::rate_form) g = product(g, inverse(f));
      }
      inverted += !(j > 0);
      if constexpr (Law::rate_form) {
        SymmetricTensor<double> stress = s.stress(i);
        material.template advance<D>(g, stress, s.volume[i]);
        s.set_stress(i, stress);
      }
    }
    scratch.trouble.inverted += inverted;
  }

  static void stress(const Block& block, double* const* out) {
    const State s(block);
    const Law material = law(block);
    for (int i = 0; i < block.count; ++i) {
      SymmetricTensor<double> cauchy;
      if constexpr (Law::rate_form) {
        cauchy = s.stress(i);
      } else {
        const auto r = material.template response<D>(s.deformation(i));
        const double q = 1 / r.volume_ratio;
        cauchy = {q * r.kirchhoff.xx, q * r.kirchhoff.yy, q * r.kirchhoff.xy, q * r.kirchhoff.zz};
      }
      out[0][i] = cauchy.xx;
      out[1][i] = cauchy.yy;
      out[2][i] = cauchy.xy;
      out[3][i] = cauchy.zz;
    }
  }

  static void measure(const Block& block, Totals& totals) {
    const State s(block);
    const Law material = law(block);
    const double mass = block.body->mass, reference_volume = block.body->reference_volume;
    double energy = 0, fastest = totals.squared_wave_speed;
    for (int i = 0; i < block.count; ++i) {
      double modulus, squared_stretch = 1;
      if constexpr (Law::rate_form) {
        energy += s.volume[i] * material.energy_density(s.stress(i));
        modulus = material.wave_modulus() * s.volume[i];
        if constexpr (TotalLagrangian) squared_stretch = PrincipalStretches(s.deformation(i)).smallest;
      } else {
        const PrincipalStretches stretches(s.deformation(i));
        squared_stretch = TotalLagrangian ? stretches.smallest : stretches.largest;
        const auto r = material.template response<D>(s.deformation(i));
        energy += reference_volume * r.energy;
        modulus = reference_volume * material.wave_modulus(squared_stretch, r.log_volume_ratio);
      }
      // Waves are as much faster in the reference configuration as it is longer than the current one.
      const double square = modulus / (mass * (TotalLagrangian ? squared_stretch : 1.0));
      if (!(square <= fastest)) fastest = square;
    }
    totals.strain_energy += energy;
    totals.squared_wave_speed = fastest;
  }

  static std::unique_ptr<const void, void (*)(const void*)> make(const double* parameters, Dimension dimension) {
    return {new Law(parameters, dimension), [](const void* made) { delete static_cast<const Law*>(made); }};
  }

  static constexpr LawKernels kernels{&make, Law::rate_form, &force, &deform, &stress, &measure};
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
