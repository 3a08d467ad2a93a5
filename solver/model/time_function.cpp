#include "solver/model/time_function.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trajan {

namespace {

double value(double constant, double) { return constant; }

double value(const Ramp& ramp, double t) {
  const double s = std::clamp((t - ramp.start) / ramp.duration, 0.0, 1.0);
  return ramp.smooth ? (1 - std::cos(std::numbers::pi * s)) / 2 : s;
}

double value(const Sine& sine, double t) {
  return std::sin(2 * std::numbers::pi * sine.frequency * t + sine.phase);
}

double value(const Table& table, double t) {
  const auto next = std::upper_bound(table.times.begin(), table.times.end(), t);
  if (next == table.times.begin()) return table.values.front();
  if (next == table.times.end()) return table.values.back();
  const std::size_t i = static_cast<std::size_t>(next - table.times.begin());
  const double share = (t - table.times[i - 1]) / (table.times[i] - table.times[i - 1]);
  return std::lerp(table.values[i - 1], table.values[i], share);
}

double value(const Formula& formula, double t) { return formula({}, t); }

}  // namespace

double TimeFunction::operator()(double t) const {
  return std::visit([t](const auto& kind) { return value(kind, t); }, kind_);
}

}  // namespace trajan
