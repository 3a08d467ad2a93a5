#pragma once

#include <variant>

#include "solver/model/formula.h"
#include "solver/scene/scene.h"

namespace trajan {

/// A dimensionless factor that depends on time (loads.proto, TimeFunction).
class TimeFunction {
 public:
  using Kind = std::variant<double, Ramp, Sine, Table, Formula>;
  TimeFunction() : kind_(1.0) {}
  explicit TimeFunction(Kind kind) : kind_(std::move(kind)) {}
  /// Throws FormulaNotFinite.
  double operator()(double t) const;

 private:
  Kind kind_;
};

}  // namespace trajan
