#pragma once

#include <string>
#include <string_view>

namespace trajan::client {

/// What the units of a scene are called, made from its `units` "length, time, mass": for labels only.
class UnitLabels {
 public:
  /// Anything but a list of at least three short names gives no labels at all.
  explicit UnitLabels(std::string_view units);

  std::string time() const { return time_; }
  std::string length() const { return length_; }
  /// Of a column of the histories such as `tip.velocity.x`, or of a field such as `stress.xx`; empty if there
  /// is none to tell.
  std::string of_column(std::string_view column) const;

 private:
  /// What people call the units that follow from some lists of base units.
  struct Derived {
    std::string_view length, time, mass, stress, energy, momentum, force;
  };
  const Derived* derived() const;

  std::string length_;
  std::string time_;
  std::string mass_;
};

/// "velocity (m/s)", or "velocity" without a unit.
std::string with_unit(const std::string& label, const std::string& unit);

}  // namespace trajan::client
