#pragma once

#include "solver/materials/damaged_tables.h"
#include "solver/materials/wave_modulus.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

template <class Law, int N, class T>
concept Relaxing = requires(const Law& law, Tensor<N, T>& g, const RateState<N, T>& state) {
  law.relax(g, state);
};

/// An elastic law with Weibull damage: its stress times what is left of its stiffness. The state of a rate law
/// is the undamaged stress. Parameters are the base's, then those of damage.
template <class Base>
class Damaged : private Base {
  static_assert(history_count<Base>() == 0, "damage is for elastic laws");
  static constexpr auto name_text = damaged_name<Base>();

 public:
  static constexpr std::string_view name = name_text;
  static constexpr std::string_view source = "Deng and Gu 2011; Asiri 2022, eq. 5.2-5.10";
  static constexpr auto parameters = damaged_parameters<Base>();
  static constexpr bool rate_form = Base::rate_form;
  static constexpr HistoryVariable history[] = {
      {"damage", "1", "share of the elements that have failed", 0},
      {"relative_stiffness", "1", "stress over that without damage and pores", 1},
      {"relative_strength", "1", "strength over that of the material", 1},
      {"dissipated_energy", "stress", "energy per reference volume that has become cracks", 0}};
  template <class T = double>
  using History = std::array<T, 4>;
  template <class T>
  using Drive = WeibullDamage::Drive<T>;

  static Objection check(const double* values, Dimension dimension) {
    if constexpr (requires { Base::check(values, dimension); })
      if (const Objection wrong = Base::check(values, dimension); !wrong.problem.empty()) return wrong;
    return check_weibull_damage(values + std::size(Base::parameters));
  }
  static std::string_view objection(Dimension dimension, bool total_lagrangian) {
    if constexpr (requires { Base::objection(dimension, total_lagrangian); })
      return Base::objection(dimension, total_lagrangian);
    return "";
  }

  Damaged(const double* values, double density)
      : Base(values, density), damage_(values + std::size(Base::parameters)) {}

  void begin(std::uint64_t particle, double* h) const {
    h[1] = damage_.pores(0.0).stiffness;
    h[2] = damage_.relative_strength(particle);
  }
  double dissipated_energy(const History<>& h) const { return h[3]; }
  const WeibullDamage& damage() const { return damage_; }

  template <int N, class T>
  Response<N, T> response(const Tensor<N, T>& f, const History<T>& h) const {
    const Response<N, T> r = Base::response(f);
    const T compressive = Extremes<T>((1.0 / determinant(f)) * r.kirchhoff).compressive;
    return {h[1] * r.kirchhoff, (1.0 - h[0]) * damage_.pores(compressive).stored_share * r.energy};
  }
  template <int N, class T>
  void evolve(const Tensor<N, T>& f, double, History<T>& h) const {
    const Response<N, T> r = Base::response(f);
    const Drive<T> drive = drive_of((1.0 / determinant(f)) * r.kirchhoff, h);
    grow(damage_.damage(drive.ratio), drive, r.energy, h);
  }
  /// Without damage and pores, which is more than with them.
  template <Dimension D, int N>
  double wave_modulus(const Tensor<N>& f, bool total_lagrangian) const requires(!rate_form) {
    return trajan::wave_modulus<D>(static_cast<const Base&>(*this), f, {}, total_lagrangian);
  }

  template <int N, class T>
  void advance(const Tensor<N, T>& g, double dt, RateState<N, T, 4>& state) const {
    RateState<N, T> base = undamaged(state);
    Base::advance(g, dt, base);
    state.stress = base.stress;
  }
  template <int N, class T>
  Drive<T> drive(const RateState<N, T, 4>& state) const requires rate_form {
    return drive_of(state.stress, state.history);
  }
  template <int N, class T>
  void grow(const T& failed, const Drive<T>& drive, RateState<N, T, 4>& state) const requires rate_form {
    grow(failed, drive, state.volume_ratio * Base::energy_density(undamaged(state)), state.history);
  }
  template <int N, class T>
  void relax(Tensor<N, T>& g, const RateState<N, T, 4>& state) const requires Relaxing<Base, N, T> {
    Base::relax(g, undamaged(state));
  }
  template <int N, class T>
  SymmetricTensor<N, T> cauchy(const RateState<N, T, 4>& state) const {
    return state.history[1] * state.stress;
  }
  template <int N>
  double energy_density(const RateState<N, double, 4>& state) const {
    const double share = damage_.pores(Extremes<double>(state.stress).compressive).stored_share;
    return (1 - state.history[0]) * share * Base::energy_density(undamaged(state));
  }
  template <int N>
  LameConstants moduli(const RateState<N, double, 4>& state) const {
    LameConstants moduli = Base::moduli(undamaged(state));
    moduli.lambda *= 1 - state.history[0];
    moduli.mu *= 1 - state.history[0];
    return moduli;
  }

 private:
  template <int N, class T>
  static RateState<N, T> undamaged(const RateState<N, T, 4>& state) {
    return {state.stress, state.volume_ratio, {}};
  }

  /// Principal stresses, each positive in its direction.
  template <class T>
  struct Extremes {
    T compressive, tensile;
    template <int N>
    explicit Extremes(const SymmetricTensor<N, T>& stress) {
      const std::array<T, 3> s = eigenvalues(stress);
      tensile = larger(s[0], larger(s[1], s[2]));
      compressive = larger(-s[0], larger(-s[1], -s[2]));
    }
  };

  /// By the base's Cauchy stress.
  template <int N, class T>
  Drive<T> drive_of(const SymmetricTensor<N, T>& stress, const History<T>& h) const {
    const Extremes<T> s(stress);
    return damage_.drive(s.compressive, s.tensile, h[2]);
  }
  /// Lets damage grow to what has failed, at this energy per reference volume of the base.
  template <class T>
  void grow(const T& failed, const Drive<T>& drive, const T& energy, History<T>& h) const {
    const T grown = larger(h[0], failed);
    h[3] = h[3] + (grown - h[0]) * drive.pores.stored_share * energy;
    h[0] = grown;
    h[1] = (1.0 - grown) * drive.pores.stiffness;
  }

  WeibullDamage damage_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
