#pragma once

#include "solver/materials/power.h"
#include "solver/materials/tensor_inverse.h"
#include "solver/materials/tensor_products.h"
#include "solver/scene/scene.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// A particle whose law feels a volume ratio that it shares with others. H is its deformation gradient, or that of
/// a step, J its volume ratio and T the shared one. The law feels H' = (T / J)^(1/d) H, where d is the number of
/// axes along which volume changes (de Souza Neto, Peric, Dutko and Owen 1996); in a geometrically linear law
/// J = 1 + tr(H - 1) and H' = H + (T - J) / d. The energy W(H') of the particle is a function of H and T.
template <Dimension D>
struct VolumeSharing {
  static constexpr int N = grid_axes(D), axes = D == Dimension::plane_strain ? 2 : 3;
  static constexpr int components = N * N + (D == Dimension::axisymmetric ? 1 : 0);

  bool linear;
  double factor;  ///< J over the determinant of H, if the law is not linear

  /// In the order of solver/schemes/law_response.h.
  template <class T>
  static T& component(Tensor<N, T>& h, int c) {
    return c < N * N ? h(c / N, c % N) : h.diagonal[2];
  }
  static Tensor<N> read(const double* values, Tensor<N> h) {
    for (int c = 0; c < components; ++c) component(h, c) = values[c];
    return h;
  }
  static void write(Tensor<N> h, double* values) {
    for (int c = 0; c < components; ++c) values[c] = component(h, c);
  }

  template <class T>
  T ratio(const Tensor<N, T>& h) const {
    return linear ? trace(h) - 2.0 : factor * determinant(h);
  }
  /// Its derivative by H.
  template <class T>
  Tensor<N, T> ratio_slope(const Tensor<N, T>& h) const {
    return linear ? identity<N, T>() : ratio(h) * transpose(inverse(h));
  }
  template <class T>
  Tensor<N, T> felt(const Tensor<N, T>& h, const T& shared) const {
    if (linear) return h + in_volume(((shared - ratio(h)) * (1.0 / axes)) * identity<N, T>());
    Tensor<N, T> r = power(shared / ratio(h), 1.0 / axes) * h;
    if constexpr (axes < 3) r.diagonal[2] = h.diagonal[2];
    return r;
  }

  template <class T>
  struct Slopes {
    Tensor<N, T> by_gradient;  ///< dW / dH while T is constant
    T by_shared;               ///< dW / dT
  };
  /// Of W, from its derivative by H'; what is not among the components is 0.
  template <class T>
  Slopes<T> slopes(const Tensor<N, T>& h, const T& shared, const Tensor<N, T>& force) const {
    if (linear) {
      const T mean = trace(force) * (1.0 / axes);
      return {force - in_volume(mean * identity<N, T>()), mean};
    }
    const T own = ratio(h), mean = double_contraction(force, felt(h, shared)) / (axes * shared);
    return {power(shared / own, 1.0 / axes) * force - in_volume((mean * shared / own) * ratio_slope(h)), mean};
  }

 private:
  /// Without the axis along which nothing changes.
  template <class T>
  static Tensor<N, T> in_volume(Tensor<N, T> a) {
    if constexpr (axes < 3) a.diagonal[2] = T(0.0);
    return a;
  }
};

/// Calls of.operator()<D>() for the dimensions in which volume is held.
template <class Of>
void in_volume_dimension(Dimension dimension, Of&& of) {
  if (dimension == Dimension::plane_strain) of.template operator()<Dimension::plane_strain>();
  if (dimension == Dimension::axisymmetric) of.template operator()<Dimension::axisymmetric>();
  if (dimension == Dimension::solid) of.template operator()<Dimension::solid>();
}

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
