#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "solver/model/expression.h"

namespace trajan {

/// A formula has no finite value where a running simulation needs one.
struct FormulaNotFinite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A formula of place and time that knows the scene's field it stands in and whether place matters.
class Formula {
 public:
  Formula(Expression expression, std::string field, bool uniform)
      : expression_(std::move(expression)), field_(std::move(field)), uniform_(uniform) {}
  /// Throws FormulaNotFinite.
  double operator()(Vector at, double t) const;
  /// The same everywhere.
  bool uniform() const { return uniform_; }
  const std::string& field() const { return field_; }
  const std::string& text() const { return expression_.text(); }

 private:
  Expression expression_;
  std::string field_;
  bool uniform_;
};

/// Empty components: not given.
using VectorFormula = std::array<std::optional<Formula>, 3>;

}  // namespace trajan
