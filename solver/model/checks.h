#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solver/model/model.h"
#include "solver/model/violations.h"

namespace trajan {

/// What the validation of all parts of a scene has in common: limits, the model so far, and what is checked
/// in many places.
class Checks {
 public:
  static constexpr std::size_t most_entries = 1000;  ///< of every list with names
  static constexpr double most_particles = 1e9;
  static constexpr double most_counting = 4e6;        ///< rows of shapes looked at to count particles
  static constexpr double most_in_box = 1e11;         ///< places of particles in the box around a geometry
  static constexpr std::size_t most_shapes = 10'000;  ///< in set operations
  static constexpr double most_cells = 1 << 30;       ///< along an axis
  static constexpr double most_selected = 1e7;        ///< particles that all mean probes list together
  static constexpr std::size_t most_formula_characters = 200'000;  ///< of all formulas together
  static constexpr double most_load_points = 1e6;
  static constexpr double most_history_values = 1e9;
  static constexpr std::size_t most_contact_pairs = 1'000'000;
  static constexpr double node_tolerance = 1e-9;  ///< cell sizes
  static constexpr int history_checks = 256;      ///< times at which formulas of t are looked at

 protected:
  explicit Checks(const Scene& scene) : scene_(scene) {}

  /// How many axes the dimension has.
  int axes() const { return grid_axes(model_.dimension); }
  /// The letters that formulas of a place may use: "x", "xy" or "xyz".
  std::string place_variables() const;
  static constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};
  static constexpr std::array<double Vector::*, 3> component = {&Vector::x, &Vector::y, &Vector::z};
  /// Finite, and 0 along axes that the dimension does not have.
  bool check_vector(const std::string& path, Vector value);
  /// A component was given that the dimension does not have.
  void no_axis(const std::string& path, const std::string& value, int axis);
  /// upper > lower, or at least >= unless `strictly`, along every axis.
  bool is_above(Vector lower, Vector upper, bool strictly) const;
  /// Whether the list is short enough to be looked at. Checks the names in it as well.
  template <typename Entries>
  bool check_list(const std::string& path, const Entries& entries);
  void check_names(const std::string& path, const std::vector<std::string>& names);
  /// A given and finite region, of some extent if `solid`.
  bool check_region(const std::string& path, const Region& region, bool solid, int depth = 0);
  template <class Shape>
  bool check_shape(const std::string& path, const Shape& shape, bool solid, int depth);
  bool check_parts(const std::string& path, const std::vector<Part>& parts, std::size_t fewest, bool solid,
                   int depth);
  bool fits_dimension(const std::string& path, bool fits);
  /// The formula, if it is right and finite at (at, t).
  std::optional<Expression> formula(const std::string& path, const std::string& text, const std::string& variables,
                                    Vector at = {}, double t = 0);
  /// Formulas for the components that the dimension has; the others are violations.
  void field(const std::string& path, const VectorExpression& formulas, const std::string& variables, Vector at,
             std::array<std::optional<Expression>*, 3> components);
  /// The same for a formula of t, and of `place` if it is not empty, at many times of the analysis.
  std::optional<Expression> history_formula(const std::string& path, const std::string& text,
                                            const std::string& place = "", Vector at = {});
  /// The same for the components that are given.
  VectorFormula motion_formulas(const std::string& path, const VectorExpression& formulas,
                                const std::string& place = "", Vector at = {});
  /// Whether a formula that is right does without the place.
  bool is_uniform(const std::string& text) const;
  static Formula zero() { return {Expression("0", "t", {}), "", true}; }
  /// Index of the body of this name; says so if there is none.
  std::optional<std::size_t> find_body(const std::string& path, const std::string& name);
  /// Indices of the bodies of these names, each once; of all bodies if there are none.
  std::vector<std::size_t> named_bodies(const std::string& path, const std::vector<std::string>& names);
  /// There is no `what` of this name; `known` are those that there are.
  void unknown_name(const std::string& path, const std::string& name, const std::string& what,
                    const std::vector<std::string>& known);
  /// Whether the body's lattice can be used.
  bool is_complete(std::size_t body) const;

  const Scene& scene_;
  Model model_;
  Violations violations_;
  Constants constants_;
  bool grid_complete_ = false;
  bool clock_complete_ = false;       ///< end_time and samples are right
  std::vector<std::string> columns_;  ///< of the histories, without those of broken probes
  std::set<std::string> broken_probes_;
  std::vector<bool> body_complete_;
  std::map<std::string, std::size_t, std::less<>> body_index_;
  std::size_t formula_characters_ = 0;
  double load_points_ = 0;
  double counting_ = 0;
  std::size_t shapes_ = 0;
  double selected_ = 0;
};

template <typename Entries>
bool Checks::check_list(const std::string& path, const Entries& entries) {
  if (entries.size() > most_entries) {
    return violations_.add(path, std::to_string(entries.size()) + " entries", "the list is too long",
                           "give at most " + std::to_string(most_entries));
  }
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  check_names(path, names);
  return true;
}

}  // namespace trajan
