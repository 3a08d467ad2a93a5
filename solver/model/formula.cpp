#include "solver/model/formula.h"

#include <cmath>

#include "solver/model/names.h"

namespace trajan {

double Formula::operator()(Vector at, double t) const {
  const double value = expression_(at, t);
  if (std::isfinite(value)) return value;
  const std::string place = uniform_ ? "" : " at " + point_text(at, 3);
  const std::string what = std::isnan(value) ? "not a number" : number_text(value);
  throw FormulaNotFinite(field_ + " is " + what + place + " at t = " + number_text(t));
}

}  // namespace trajan
