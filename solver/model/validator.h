#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solver/model/expression.h"
#include "solver/model/model.h"
#include "solver/model/violations.h"

namespace trajan {

/// Checks a scene part by part and builds the Model on the way. Each part has its own source file,
/// validate_<part>.cpp. A part that depends on another is checked as far as the other was right.
class Validator {
 public:
  explicit Validator(const Scene& scene) : scene_(scene) {}
  Model run();

  static constexpr std::size_t most_entries = 1000;  ///< of every list with names
  static constexpr double most_particles = 1e9;
  static constexpr double most_cells = 1 << 30;  ///< along an axis
  static constexpr double most_selected = 1e7;   ///< particles that all mean probes list together
  static constexpr std::size_t most_formula_characters = 200'000;  ///< of all formulas together
  static constexpr double most_load_points = 1e6;
  static constexpr double most_history_values = 1e9;
  static constexpr double node_tolerance = 1e-9;  ///< cell sizes

 private:
  void check_head();
  void check_constants();
  void check_domain();
  void check_extent();
  void check_grid(const std::string& path);
  void check_materials();
  void check_use(const std::string& path, const MaterialKind& kind);
  void check_law(const std::string& path, const MaterialDefinition& definition, Material& material);
  bool read_parameters(const std::string& path, std::span<const Parameter> table,
                       const std::map<std::string, double>& values, Material& material);
  /// Makes the material's law the same with damage.
  bool add_damage(const std::string& path, const std::map<std::string, double>& values, Material& material);
  void check_law_as_a_whole(const std::string& path, const std::string& law_path, const Material& material);
  bool check_parameter(const std::string& path, const Parameter& parameter, double value);
  void check_bodies();
  bool check_body(const std::string& path, const BodyDefinition& definition, Body& body);
  bool fill_body(const std::string& path, const BodyDefinition& definition, Body& body);
  std::string box_text(const Box& box) const;
  void check_boundaries();
  void check_boundary(const std::string& path, const BoundaryDefinition& definition);
  void check_condition(const std::string& path, const Fixed& fixed, NodeCondition& condition);
  void check_condition(const std::string& path, const PrescribedVelocity& prescribed, NodeCondition& condition);
  void check_loads();
  void check_load(const std::string& path, const LoadDefinition& definition);
  std::vector<LoadPoint> load_points(const std::string& path, const PointForce& force);
  std::vector<LoadPoint> load_points(const std::string& path, const EdgeTraction& traction);
  std::vector<std::size_t> loaded_bodies(const std::string& path, const BodyForce& force);
  std::optional<TimeFunction> time_function(const std::string& path, const TimeFunctionDefinition& definition);
  void check_analysis();
  void check_numerics();
  void check_combinations();
  void check_time_step();
  void check_outputs();
  bool check_fields(const std::string& path, const std::vector<Field>& fields);
  /// Names of history variables that the laws of all these bodies have, or of some of them.
  bool check_history(const std::string& path, const std::vector<std::string>& history,
                     const std::vector<std::size_t>& bodies, bool in_all);
  /// Empty as well if the body's law is wrong.
  std::span<const HistoryVariable> history_of(const Body& body) const;
  /// Which history variable of the body's law has this name; -1: none.
  int history_place(const Body& body, const std::string& name) const;
  std::vector<RecordedField> recorded_fields(const std::vector<Field>& fields,
                                             const std::vector<std::string>& history) const;
  void check_snapshot_fields();
  void check_snapshots();
  void check_probe(const std::string& path, const ProbeDefinition& definition);
  std::vector<std::int64_t> nearest(const std::string& path, Vector place, const std::vector<std::size_t>& bodies);
  std::vector<std::int64_t> within_region(const std::string& path, const Region& region,
                                          const std::vector<std::size_t>& bodies);
  void check_measures();
  void check_measure(const std::string& path, const MeasureDefinition& definition);
  void check_window(const std::string& path, const MeasureDefinition& definition, Measure& measure);
  void check_frequency(const std::string& path, const DominantFrequency& frequency);
  void check_exact(const std::string& path, const MeasureDefinition& definition, Measure& measure);

  /// How many axes the dimension has.
  int axes() const { return grid_axes(model_.dimension); }
  /// The letters that formulas of a place may use: "x", "xy" or "xyz".
  std::string place_variables() const;
  static constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};
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
  bool check_region(const std::string& path, const Region& region, bool solid);
  /// The formula, if it is right and finite at (at, t).
  std::optional<Expression> formula(const std::string& path, const std::string& text, const std::string& variables,
                                    Vector at = {}, double t = 0);
  /// Formulas for the components that the dimension has; the others are violations.
  void field(const std::string& path, const VectorExpression& formulas, const std::string& variables, Vector at,
             std::array<std::optional<Expression>*, 3> components);
  /// The same for a formula of t at the beginning and at the end of the analysis.
  std::optional<Expression> history_formula(const std::string& path, const std::string& text);
  /// Index of the body of this name; says so if there is none.
  std::optional<std::size_t> find_body(const std::string& path, const std::string& name);
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
  double selected_ = 0;
};

template <typename Entries>
bool Validator::check_list(const std::string& path, const Entries& entries) {
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
