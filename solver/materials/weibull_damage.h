#pragma once

#include <cstdint>
#include <string>

#include "solver/materials/material.h"
#include "solver/materials/power.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// The table of Weibull damage, which any elastic law may be combined with (solver/materials/damaged.h).
inline constexpr Parameter weibull_damage_parameters[] = {
    {"compressive_strength", "stress", "scale of the distribution of compressive strength", 0, 1e300, not_given},
    {"tensile_strength", "stress", "scale of the distribution of tensile strength", 0, 1e300, not_given},
    {"shape", "1", "shape m of both distributions: the larger, the more brittle", 0, 1000},
    {"closure_stress", "stress", "compressive stress at which pores are closed", 0, 1e300, 0, true},
    {"open_stiffness", "1", "share of the stiffness while pores are open", 0, 1, 1, false, true},
    {"scatter_shape", "1", "shape of the Weibull distribution of strengths among particles", 0, 1e300, not_given},
    {"seed", "1", "of the strengths' random numbers", 0, 0x1p53, 0, true, true}};
inline constexpr std::size_t weibull_damage_count = std::size(weibull_damage_parameters);

/// What is wrong with the values together, or empty.
inline Objection check_weibull_damage(const double* values) {
  if (values[0] == not_given && values[1] == not_given)
    return {"neither compressive_strength nor tensile_strength is given", "give at least one"};
  if ((values[3] > 0) != (values[4] < 1))
    return {"of closure_stress and open_stiffness one alone has no effect", "give both or neither"};
  return {};
}

/// Damage of rock: the share D of its mesoscopic elements that have failed, whose strengths have a Weibull
/// distribution: D = 1 - exp(-(sigma / f)^m) (Deng and Gu 2011; dissertation, eq. 5.9). sigma is the largest
/// principal stress, compressive or tensile, that the material would have without damage. That is the one reading
/// of the dissertation's eq. 5.10 under which rock softens: in a uniaxial test
///   stress = E strain exp(-(E strain / f)^m),   with its peak f (e m)^(-1/m) at E strain = f m^(-1/m);
/// with the damaged stress for sigma the curve would rise for ever. D never falls.
///
/// Pores that are open at first and close under pressure give marble's curve its concave beginning
/// (dissertation, fig. 29). Until they are closed the tangent modulus rises linearly with the strain from a
/// given share r of the full one: with s, the stress of the elastic law, c that at which pores are closed, and
/// x = s / c,
///   stress = c (r x + (1 - r) x^2 / 2) for x < 1, c (x - (1 - r) / 2) beyond,
/// and r s in tension; the stress at closure is c (1 + r) / 2. All components of the stress are scaled alike, x
/// being that of the largest compressive principal stress; the toe is elastic, and it is this stress that damage
/// is driven by.
class WeibullDamage {
 public:
  explicit WeibullDamage(const double* values)
      : inverse_compressive_(1 / values[0]),
        inverse_tensile_(1 / values[1]),
        shape_(values[2]),
        open_(values[4]),
        inverse_closure_(values[3] > 0 ? 0.5 * (1 + values[4]) / values[3] : 0),
        scatter_shape_(values[5]),
        seed_(static_cast<std::uint64_t>(values[6])) {}

  /// Strength of a particle relative to that of the table: 1, or a number with a Weibull distribution of scale 1.
  double relative_strength(std::uint64_t particle) const {
    if (scatter_shape_ == not_given) return 1;
    return power(-natural_logarithm(random(particle)), 1 / scatter_shape_);
  }

  template <class T>
  struct Pores {
    T stiffness;     ///< stress in shares of the undamaged one
    T stored_share;  ///< energy that it has stored, in shares of that of the elastic law, if it rose in proportion
  };
  /// For the largest compressive principal stress s without damage.
  template <class T>
  Pores<T> pores(const T& s) const {
    const T x = choose(s > 0, s, T(0.0)) * inverse_closure_, y = choose(x < 1, T(1.0), x), q = 1.0 / y;
    const double rest = 1 - open_;
    return {choose(x < 1, open_ + 0.5 * rest * x, 1 - 0.5 * rest * q),
            choose(x < 1, open_ + rest / 3 * x, 1 - rest * (y - 1.0 / 3) * (q * q))};
  }
  /// What damage grows by.
  template <class T>
  struct Drive {
    T ratio;  ///< sigma / f
    Pores<T> pores;
  };
  /// Of these principal stresses of the elastic law, each taken in the direction of failure.
  template <class T>
  Drive<T> drive(const T& compressive, const T& tensile, const T& strength) const {
    const Pores<T> open = pores(compressive);
    const T ratio = larger(compressive * inverse_compressive_, tensile * inverse_tensile_) / strength;
    return {open.stiffness * ratio, open};
  }
  /// m ln(sigma / f): the logarithm of (sigma / f)^m, which of a distribution is its hazard summed up.
  template <class T>
  T log_hazard(const T& ratio) const {
    return log_power(ratio, shape_);
  }
  template <class T>
  T hazard(const T& log_hazard) const {
    return exponential(log_hazard);
  }
  template <class T>
  T failed(const T& hazard) const {
    const T failed = 1 - exponential(-hazard);
    return choose(failed < largest_damage, failed, T(largest_damage));
  }
  /// The share that fails at this ratio of stress to strength.
  template <class T>
  T damage(const T& ratio) const {
    return failed(hazard(log_hazard(ratio)));
  }

 private:
  /// What is left keeps broken particles from losing all stiffness, and their state from being forgotten.
  static constexpr double largest_damage = 1 - 0x1p-20;

  /// Between 0 and 1, by the particle's number alone (SplitMix64; Steele, Lea and Flood 2014).
  double random(std::uint64_t particle) const {
    std::uint64_t z = seed_ * 0xD1342543DE82EF95u + (particle + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return (static_cast<double>(z >> 11) + 0.5) * 0x1p-53;
  }

  double inverse_compressive_, inverse_tensile_, shape_, open_, inverse_closure_, scatter_shape_;
  std::uint64_t seed_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
