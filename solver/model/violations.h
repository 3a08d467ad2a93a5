#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/model/validate.h"

namespace trajan {

/// Collects what is wrong with a scene. Checks return whether all was well, so that what depends on a
/// bad value is not checked, and one mistake gives one violation.
class Violations {
 public:
  /// More are dropped: nobody reads them, and a hostile scene could ask for a great many.
  static constexpr std::size_t most = 1000;

  /// Always false.
  bool add(std::string path, std::string value, std::string problem, std::string remedy);
  bool finite(const std::string& path, double value);
  /// Finite and > 0.
  bool positive(const std::string& path, double value);
  /// Finite and >= 0.
  bool not_negative(const std::string& path, double value);
  /// lowest <= value <= highest.
  bool within(const std::string& path, double value, double lowest, double highest);

  bool empty() const { return violations_.empty(); }
  /// Hints cost time: they are worth it for the first violations only.
  bool worth_a_hint() const { return violations_.size() < 100; }
  std::vector<Violation> take() { return std::move(violations_); }

 private:
  std::vector<Violation> violations_;
};

/// "bodies", 2 → "bodies[2]"
std::string indexed(const std::string& path, std::size_t index);

}  // namespace trajan
