#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

std::optional<Expression> Checks::formula(const std::string& path, const std::string& text,
                                          const std::string& variables, Vector at, double t) {
  formula_characters_ += std::min(text.size(), Expression::longest);
  if (formula_characters_ > most_formula_characters) {
    violations_.add(path, text, "the scene's formulas are too long",
                    "give at most " + std::to_string(most_formula_characters) + " characters in all of them");
    return std::nullopt;
  }
  try {
    Expression expression(text, variables, constants_);
    const double value = expression(at, t);
    if (std::isfinite(value)) return expression;
    std::string place;
    if (variables.find('x') != std::string::npos) place = " at " + point_text(at, axes());
    if (variables.find('t') != std::string::npos) place = " at t = " + number_text(t);
    violations_.add(path, text, "the formula is " + number_text(value) + place,
                    "give a formula that is finite there");
  } catch (const FormulaError& error) {
    violations_.add(path, text, error.what(), error.remedy());
  }
  return std::nullopt;
}

std::optional<Expression> Checks::history_formula(const std::string& path, const std::string& text,
                                                  const std::string& place, Vector at) {
  auto expression = formula(path, text, place + "t", at);
  const double end = model_.end_time;
  if (!expression || !std::isfinite(end)) return expression;
  for (int i = 1; i <= history_checks; ++i) {
    const double t = end * i / history_checks;
    if (std::isfinite((*expression)(at, t))) continue;
    violations_.add(path, text, "the formula is not finite at t = " + number_text(t),
                    "give a formula that is finite until the end");
    return std::nullopt;
  }
  return expression;
}

VectorFormula Checks::motion_formulas(const std::string& path, const VectorExpression& formulas,
                                      const std::string& place, Vector at) {
  const std::optional<std::string>* given[] = {&formulas.x, &formulas.y, &formulas.z};
  VectorFormula made;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!*given[axis]) continue;
    const std::string& text = **given[axis];
    const std::string field = path + "." + axis_names[axis];
    if (static_cast<int>(axis) >= axes()) {
      no_axis(field, text, static_cast<int>(axis));
    } else if (auto expression = history_formula(field, text, place, at)) {
      made[axis].emplace(std::move(*expression), field, is_uniform(text));
    }
  }
  return made;
}

bool Checks::is_uniform(const std::string& text) const {
  try {
    Expression(text, "t", constants_);
    return true;
  } catch (const FormulaError&) {
    return false;
  }
}

void Checks::field(const std::string& path, const VectorExpression& formulas, const std::string& variables,
                   Vector at, std::array<std::optional<Expression>*, 3> components) {
  const std::optional<std::string>* given[] = {&formulas.x, &formulas.y, &formulas.z};
  for (int axis = 0; axis < 3; ++axis) {
    const auto& text = *given[axis];
    if (!text) continue;
    const std::string place = path + "." + axis_names[axis];
    if (axis < axes()) {
      *components[static_cast<std::size_t>(axis)] = formula(place, *text, variables, at);
    } else {
      no_axis(place, *text, axis);
    }
  }
}

}  // namespace trajan
