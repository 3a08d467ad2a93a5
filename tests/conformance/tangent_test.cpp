#include <gtest/gtest.h>

#include "solver/materials/free_rest.h"
#include "solver/materials/laws.h"
#include "solver/materials/wave_modulus.h"
#include "tests/conformance/material_point.h"

/// Derivatives of every law by dual numbers against finite differences of the law itself.
namespace trajan::test {
namespace {

template <int N>
Tensor<N> some_gradient(double size) {
  Tensor<N> g{};
  for (int k = 0; k < 3; ++k) g.diagonal[k] = size * (0.6 - 0.4 * k);
  for (int k = 0; k < Tensor<N>::off_count; ++k) g.off[k] = size * (0.5 - 0.3 * k);
  return g;
}

/// Stress after a step of gradient `g` from some stressed state: of Kirchhoff, for rate laws of Cauchy.
template <int N, class Law, class T>
SymmetricTensor<N, T> stress_after(const Law& law, const Tensor<N, T>& g) {
  HistoryOf<Law, T> history{};
  const HistoryOf<Law> initial = initial_history(law, 0);
  std::copy(initial.begin(), initial.end(), history.begin());
  if constexpr (Law::rate_form) {
    RateState<N, T, history_count<Law>()> state{{}, T(1.0), history};
    advance_state(law, cast<T>(some_gradient<N>(1e-3)), 1e-3, state);
    advance_state(law, g, 1e-3, state);
    return cauchy_stress(law, state);
  } else {
    const Tensor<N, T> f = product(plus_diagonal(g, 1.0), cast<T>(plus_diagonal(some_gradient<N>(0.1), 1.0)));
    if constexpr (history_count<Law>() > 0) law.evolve(f, 1e-3, history);
    return respond(law, f, history).kirchhoff;
  }
}

template <int N, class Law>
void expect_tangent(const Law& law) {
  constexpr int K = 3 + Tensor<N>::off_count;
  const Tensor<N> g = some_gradient<N>(0.01);
  Tensor<N, Dual<K>> variable = cast<Dual<K>>(g);
  for (int k = 0; k < K; ++k) {
    Dual<K>& component = k < 3 ? variable.diagonal[k] : variable.off[k - 3];
    component = Dual<K>(component.value, k);
  }
  const SymmetricTensor<N, Dual<K>> tangent = stress_after(law, variable);
  for (int k = 0; k < K; ++k) {
    const double d = 1e-6;
    Tensor<N> change{};
    (k < 3 ? change.diagonal[k] : change.off[k - 3]) = d;
    const SymmetricTensor<N> ahead = stress_after(law, g + change), behind = stress_after(law, g - change);
    const SymmetricTensor<N> slope = (1 / (2 * d)) * (ahead - behind);
    // Truncation d^2 and rounding eps / d, both times moduli of some 1000.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(tangent.diagonal[i].slope[k], slope.diagonal[i], 1e-5) << i << k;
    for (int i = 0; i < SymmetricTensor<N>::off_count; ++i)
      EXPECT_NEAR(tangent.off[i].slope[k], slope.off[i], 1e-5) << i << k;
  }
}

template <class Law>
class Tangent : public testing::Test {};

template <class First, class... Others>
testing::Types<Others...> without_first(testing::Types<First, Others...>);
#define TRAJAN_LISTED(Law) , Law
using Laws = decltype(without_first(testing::Types<void TRAJAN_FOR_EACH_LAW(TRAJAN_LISTED)>{}));
#undef TRAJAN_LISTED

struct LawNames {
  template <class Law>
  static std::string GetName(int) {
    return std::string(Law::name);
  }
};
TYPED_TEST_SUITE(Tangent, Laws, LawNames);

TYPED_TEST(Tangent, IsWhatFiniteDifferencesFind) {
  for (const std::vector<double>& parameters : sample_parameters(*find_material_kind(TypeParam::name))) {
    SCOPED_TRACE(testing::PrintToString(parameters));
    const TypeParam law(parameters.data(), 1);
    expect_tangent<1>(law);
    expect_tangent<2>(law);
    expect_tangent<3>(law);
  }
}

}  // namespace
}  // namespace trajan::test
