#pragma once

#include "solver/materials/law.h"
#include "solver/materials/logarithm.h"

namespace trajan {
inline namespace TRAJAN_INSTRUCTION_SET {

/// Compressible Mooney-Rivlin solid, strain energy per reference volume
/// c (J - 1)^2 - d ln J + c1 (I1 - 3) + c2 (I2 - 3), d = 2 (c1 + 2 c2), I1 and I2 invariants of b = F F^T.
/// At small strain mu = 2 (c1 + c2) and lambda = 2 c + 4 c2.
class MooneyRivlin {
 public:
  static constexpr std::string_view name = "mooney_rivlin";
  static constexpr std::string_view source =
      "tau = 2 c1 b + 2 c2 (I1 b - b^2) + (2 c J (J - 1) - d) 1; Holzapfel 2000, eq. 6.147";
  static constexpr Parameter parameters[] = {
      {.name = "c1", .unit = "stress", .meaning = "coefficient of I1 - 3", .lowest = 0, .highest = 1e300},
      {.name = "c2",
       .unit = "stress",
       .meaning = "coefficient of I2 - 3",
       .lowest = 0,
       .highest = 1e300,
       .lowest_allowed = true},
      {.name = "bulk_modulus",
       .unit = "stress",
       .meaning = "bulk modulus at small strain",
       .lowest = 0,
       .highest = 1e300}};
  static constexpr bool rate_form = false;

  static Objection check(const double* values, Dimension) {
    if (volumetric(values) >= 0) return {};
    return {
        "bulk_modulus is less than 4/3 (c1 + c2) + 4 c2, so that c (J - 1)^2 would have to be negative",
        "give a bulk_modulus of at least " + std::to_string(4.0 / 3 * (values[0] + values[1]) + 4 * values[1])};
  }

  MooneyRivlin(const double* values, double /*density*/)
      : c1_(values[0]), c2_(values[1]), c_(volumetric(values)), d_(2 * (values[0] + 2 * values[1])) {}

  template <int N, class T>
  Response<N, T> response(const Tensor<N, T>& f) const {
    const SymmetricTensor<N, T> b = left_cauchy_green(f), b2 = square(b);
    const T j = determinant(f), i1 = trace(b), i2 = 0.5 * (i1 * i1 - trace(b2));
    const T change = j - 1.0;
    return {plus_diagonal((2 * c1_ + 2 * c2_ * i1) * b - (2 * c2_) * b2, 2 * c_ * (j * change) - d_),
            c_ * (change * change) - d_ * natural_logarithm(j) + c1_ * (i1 - 3.0) + c2_ * (i2 - 3.0)};
  }

 private:
  static double volumetric(const double* values) {
    return 0.5 * (values[2] - 4.0 / 3 * (values[0] + values[1]) - 4 * values[1]);
  }

  double c1_, c2_, c_, d_;
};

}  // namespace TRAJAN_INSTRUCTION_SET
}  // namespace trajan
