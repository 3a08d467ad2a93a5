#include "solver/model/validate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

InvalidScene::InvalidScene(std::vector<Violation> violations)
    : std::runtime_error("invalid scene: " + violations.at(0).path + ": " + violations.at(0).problem),
      violations_(std::move(violations)) {}

Model validate(const Scene& scene) { return Validator(scene).run(); }

Model Validator::run() {
  check_head();
  check_constants();
  check_domain();
  check_materials();
  check_bodies();
  check_boundaries();
  check_analysis();
  check_loads();
  check_numerics();
  check_outputs();
  check_measures();
  if (violations_.empty()) check_time_step();
  if (!violations_.empty()) throw InvalidScene(violations_.take());
  return std::move(model_);
}

void Validator::check_head() {
  if (!is_identifier(scene_.name)) {
    violations_.add("name", scene_.name,
                    scene_.name.empty() ? "a scene needs a name" : quoted(scene_.name) + " is not a valid name",
                    "use 1 to 64 letters, digits, _ or -");
  }
  model_.name = scene_.name;
  model_.description = scene_.description;
  model_.units = scene_.units;
}

void Validator::check_constants() {
  if (scene_.constants.size() > most_entries) {
    violations_.add("constants", std::to_string(scene_.constants.size()) + " entries", "the list is too long",
                    "give at most " + std::to_string(most_entries));
    return;
  }
  for (std::size_t i = 0; i < scene_.constants.size(); ++i) {
    const auto& [name, text] = scene_.constants[i];
    const std::string path = indexed("constants", i);
    const bool letter_first = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
    if (!letter_first || !is_identifier(name) || name.find('-') != std::string::npos) {
      violations_.add(path + ".name", name, quoted(name) + " is not a name that formulas can use",
                      "use a letter followed by letters, digits and _, at most 64");
    } else if (is_reserved_in_expressions(name)) {
      violations_.add(path + ".name", name, quoted(name) + " means something else in formulas",
                      "choose another name");
    } else if (constants_.contains(name)) {
      violations_.add(path + ".name", name, quoted(name) + " is the name of an earlier constant",
                      "choose another name");
    }
    const auto value = formula(path + ".value", text, "");
    // A constant that is wrong still has a name: what uses it is not wrong as well.
    constants_.emplace(name, value ? (*value)(0, 0, 0) : 1.0);
  }
}

void Validator::check_domain() {
  const Domain& domain = scene_.domain;
  if (domain.dimension == Dimension::unspecified) {
    violations_.add("domain.dimension", "", "not given", "choose PLANE_STRESS or PLANE_STRAIN");
  }
  bool good = violations_.finite("domain.lower", domain.lower);
  good = violations_.finite("domain.upper", domain.upper) && good;
  if (good && !(domain.lower.x < domain.upper.x && domain.lower.y < domain.upper.y)) {
    good = violations_.add(
        "domain.upper", point_text(domain.upper), "not above and to the right of domain.lower",
        "give upper.x > " + number_text(domain.lower.x) + " and upper.y > " + number_text(domain.lower.y));
  }
  good = violations_.positive("domain.cell_size", domain.cell_size) && good;
  violations_.positive("domain.thickness", domain.thickness);
  if (good) check_grid("domain.cell_size");
  model_.dimension = domain.dimension;
  model_.thickness = domain.thickness;
}

void Validator::check_grid(const std::string& path) {
  const Domain& domain = scene_.domain;
  const double cell = domain.cell_size;
  const auto cells = [&](double from, double to) {
    return std::max(1.0, std::ceil((to - from) / cell - node_tolerance));
  };
  const double cells_x = cells(domain.lower.x, domain.upper.x);
  const double cells_y = cells(domain.lower.y, domain.upper.y);
  if (!(std::max(cells_x, cells_y) <= most_cells)) {
    violations_.add(path, number_text(cell),
                    "this makes " + number_text(std::max(cells_x, cells_y)) + " cells along an axis",
                    "give larger cells or a smaller domain: at most 2^30 cells along an axis");
    return;
  }
  const double farthest = std::max(
      {std::abs(domain.lower.x), std::abs(domain.upper.x), std::abs(domain.lower.y), std::abs(domain.upper.y)});
  // Beyond this, coordinates are not accurate to a millionth of a cell.
  if (!(farthest / cell <= 2 * most_cells)) {
    violations_.add(path, number_text(cell), "too small for coordinates as large as " + number_text(farthest),
                    "move the scene closer to the origin: at most 2^31 cells away");
    return;
  }
  model_.grid = {domain.lower, cell, static_cast<std::int64_t>(cells_x), static_cast<std::int64_t>(cells_y)};
  grid_complete_ = true;
}

void Validator::check_names(const std::string& path, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string place = indexed(path, i) + ".name";
    if (!is_identifier(names[i])) {
      violations_.add(place, names[i],
                      names[i].empty() ? "a name is needed" : quoted(names[i]) + " is not a valid name",
                      "use 1 to 64 letters, digits, _ or -");
    } else if (!seen.insert(names[i]).second) {
      violations_.add(place, names[i], quoted(names[i]) + " is the name of an earlier entry",
                      "choose another name");
    }
  }
}

std::optional<Expression> Validator::formula(const std::string& path, const std::string& text,
                                             const std::string& variables, Vector at, double t) {
  formula_characters_ += std::min(text.size(), Expression::longest);
  if (formula_characters_ > most_formula_characters) {
    violations_.add(path, text, "the scene's formulas are too long",
                    "give at most " + std::to_string(most_formula_characters) + " characters in all of them");
    return std::nullopt;
  }
  try {
    Expression expression(text, variables, constants_);
    const double value = expression(at.x, at.y, t);
    if (std::isfinite(value)) return expression;
    std::string place;
    if (variables.find('x') != std::string::npos) place = " at " + point_text(at);
    if (variables.find('t') != std::string::npos) place = " at t = " + number_text(t);
    violations_.add(path, text, "the formula is " + number_text(value) + place,
                    "give a formula that is finite there");
  } catch (const FormulaError& error) {
    violations_.add(path, text, error.what(), error.remedy());
  }
  return std::nullopt;
}

std::optional<Expression> Validator::history_formula(const std::string& path, const std::string& text) {
  auto expression = formula(path, text, "t");
  const double end = scene_.analysis.end_time;
  if (expression && std::isfinite(end) && !std::isfinite((*expression)(0, 0, end))) {
    violations_.add(path, text, "the formula is not finite at t = " + number_text(end),
                    "give a formula that is finite until the end");
    return std::nullopt;
  }
  return expression;
}

void Validator::unknown_name(const std::string& path, const std::string& name, const std::string& what,
                             const std::vector<std::string>& known) {
  const std::string problem =
      name.empty() ? "no " + what + " is named" : "there is no " + what + " " + quoted(name);
  if (known.empty()) {
    violations_.add(path, name, problem, "define a " + what);
    return;
  }
  const std::vector<std::string> sorted = violations_.worth_a_hint() ? nearest_first(name, known) : known;
  const std::string hint = did_you_mean(name, std::span(sorted).first(1));
  violations_.add(path, name, problem,
                  hint.empty() ? "the " + plural(what) + " are: " + list_of(sorted)
                               : hint + " (" + plural(what) + ": " + list_of(sorted) + ")");
}

}  // namespace trajan
