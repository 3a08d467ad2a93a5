#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

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

std::optional<Expression> Validator::history_formula(const std::string& path, const std::string& text) {
  auto expression = formula(path, text, "t");
  const double end = scene_.analysis.end_time;
  if (expression && std::isfinite(end) && !std::isfinite((*expression)({}, end))) {
    violations_.add(path, text, "the formula is not finite at t = " + number_text(end),
                    "give a formula that is finite until the end");
    return std::nullopt;
  }
  return expression;
}

void Validator::field(const std::string& path, const VectorExpression& formulas, const std::string& variables,
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
