#pragma once

#include <cstdint>
#include <optional>
#include <vector>

/// Validated contacts between bodies.
namespace trajan {

/// Bodies that are never separate share a velocity field. Fields are numbered in the order of their first bodies.
struct ContactPlan {
  std::uint32_t fields = 1;
  std::vector<std::uint32_t> field_of;  ///< by body; empty: there is one field
  /// Coulomb's coefficient of two fields, symmetric, fields x fields; empty entries: they move as one.
  std::vector<std::optional<double>> friction;

  const std::optional<double>& between(std::uint32_t a, std::uint32_t b) const { return friction[a * fields + b]; }
};

}  // namespace trajan
