#pragma once

#include <array>
#include <concepts>
#include <iterator>
#include <string_view>

#include "solver/materials/elastic_moduli.h"
#include "solver/materials/material.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"

/// What a constitutive law is. A law is one class in one header, written once for all dimensions (N grid
/// axes) and for any number type T (double, dual numbers). It knows nothing of particles, schemes, plane
/// stress or bars: whoever calls it solves for stretches of the rest where their stress is zero.
///
/// Every law has
///   static constexpr std::string_view name, source;   the word in scene.proto, and where its equations are
///   static constexpr Parameter parameters[];           its table
///   static constexpr bool rate_form;
///   Law(const double* values, double density);         values in the order of the table; density at rest
/// and may have
///   static constexpr HistoryVariable history[];        what it remembers, at most 8
///   void begin(std::uint64_t particle, double* history) const;   initial history of one particle, if it differs
///                                                      from particle to particle (the number is the body's)
///   double diffusivity() const;                        of momentum, by viscosity: length^2 per time
///   double dissipated_energy(const std::array<double, count>& h) const;   so far, per reference volume
///   static Objection check(const double* values, Dimension);   what is wrong with the parameters together
///   static std::string_view objection(Dimension, bool total_lagrangian);  why it must not be used so, or empty
///
/// A *finite* law (rate_form = false) is a function of the deformation gradient:
///   template <int N, class T>
///   Response<N, T> response(const Tensor<N, T>& f) const;
/// or, with a history of `count` variables,
///   template <int N, class T>
///   Response<N, T> response(const Tensor<N, T>& f, const std::array<T, count>& h) const;
///   template <int N, class T>
///   void evolve(const Tensor<N, T>& f, double dt, std::array<T, count>& h) const;
/// `evolve` is called once a step with the F of its end, before `response`. An anisotropic law also gives
///   template <Dimension D, int N>
///   double wave_modulus(const Tensor<N>& f, bool total_lagrangian) const;
/// the largest eigenvalue of the acoustic tensor per reference volume for unit normals of the current, or in the
/// total Lagrangian form of the reference configuration; for isotropic laws it is found by differentiation.
///
/// A finite law with
///   static constexpr bool geometrically_linear = true;
/// takes all configurations for one: its stress is the first Piola-Kirchhoff stress as well.
///
/// A *rate* law (rate_form = true) advances its state:
///   template <int N, class T>
///   void advance(const Tensor<N, T>& g, double dt, RateState<N, T, count>& state) const;
///   template <int N>
///   LameConstants moduli(const RateState<N, double, count>& state) const;
/// `g` is the displacement gradient of the step with respect to the configuration at its beginning; volume_ratio
/// is already that of the end. `moduli` are the tangent ones of the fastest waves. A law with damage
/// lets it grow after that (solver/materials/damaged.h). A law may give
///   template <int N> double energy_density(const RateState<N, double, count>&) const;   per current volume
///   template <int N, class T> SymmetricTensor<N, T> cauchy(const RateState<N, T, count>&) const;
///                                                      what acts on others, if not the stress of the state
///   template <int N, class T> void relax(Tensor<N, T>& g, const RateState<N, T, count>&) const;
///                                                      sets the rest of g so that the rest stresses stay zero
///
/// Particles of floats are computed in floats by laws that lose none of their digits
/// (solver/schemes/law_floats.h): rate laws with
///   template <int N, class T>
///   SymmetricTensor<N, T> stress_change(const Tensor<N, T>& g, const SymmetricTensor<N, T>& stress) const;
/// which is what a step adds to the stress, and finite ones with
///   template <int N, class T> SymmetricTensor<N, T> kirchhoff_of_change(const Tensor<N, T>& h) const;
/// of h = F - 1, both to all digits of T even where they are small.
namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// What follows from a deformation gradient.
template <int N, class T = double>
struct Response {
  SymmetricTensor<N, T> kirchhoff;  ///< tau = J sigma = P F^T
  T energy;                         ///< per reference volume
};

template <class Law>
constexpr bool is_geometrically_linear() {
  if constexpr (requires { Law::geometrically_linear; })
    return Law::geometrically_linear;
  else
    return false;
}

template <class Law>
constexpr bool is_damaged() {
  return requires(const Law& law) { law.damage(); };
}

/// How many history variables a law has.
template <class Law>
constexpr int history_count() {
  if constexpr (requires { Law::history; })
    return static_cast<int>(std::size(Law::history));
  else
    return 0;
}
template <class Law, class T = double>
using HistoryOf = std::array<T, static_cast<std::size_t>(history_count<Law>())>;

template <int N, class T = double, int HistoryCount = 0>
struct RateState {
  SymmetricTensor<N, T> stress;  ///< of Cauchy
  T volume_ratio;                ///< J
  std::array<T, static_cast<std::size_t>(HistoryCount)> history;
};

template <class Law>
concept AnyLaw = requires(const double* values, double density) {
  Law(values, density);
  Law::name;
  Law::source;
  Law::parameters;
  { Law::rate_form } -> std::convertible_to<bool>;
};

/// The response of a finite law with or without a history.
template <class Law, int N, class T>
Response<N, T> respond(const Law& law, const Tensor<N, T>& f, const HistoryOf<Law, T>& history) {
  if constexpr (history_count<Law>() > 0)
    return law.response(f, history);
  else
    return law.response(f);
}

/// What acts on others in a state of a rate law.
template <class Law, int N, class T, int H>
SymmetricTensor<N, T> cauchy_stress(const Law& law, const RateState<N, T, H>& state) {
  if constexpr (requires { law.cauchy(state); })
    return law.cauchy(state);
  else
    return state.stress;
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
