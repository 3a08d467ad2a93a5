#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "solver/scene/geometry.h"

namespace trajan {

/// Values that expressions may use by name.
using Constants = std::map<std::string, double>;

/// What is wrong with a formula and where in it, and what would be right.
class FormulaError : public std::invalid_argument {
 public:
  explicit FormulaError(const std::string& problem, std::string remedy = "correct the formula")
      : std::invalid_argument(problem), remedy_(std::move(remedy)) {}
  const std::string& remedy() const { return remedy_; }

 private:
  std::string remedy_;
};

/// A formula of x, y, z and t in muParser syntax, `pi` and the scene's constants included. Copies share
/// nothing that changes; one object must not be evaluated by two threads at once.
class Expression {
 public:
  static constexpr std::size_t longest = 1024;  ///< characters; muParser takes time with their square
  static constexpr int deepest = 64;            ///< nested parentheses and conditions

  /// `variables`: the letters of "xyzt" that the formula may use.
  /// Throws FormulaError.
  Expression(const std::string& text, const std::string& variables, const Constants& constants);
  Expression(const Expression& other);
  Expression(Expression&& other) noexcept;
  Expression& operator=(Expression other) noexcept;
  ~Expression();

  /// Not finite where the formula is not defined; never throws.
  double operator()(Vector at, double t) const;
  double operator()(double x, double y, double t) const { return (*this)(Vector{x, y}, t); }
  const std::string& text() const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// Whether formulas give this name a meaning of their own: x, y, z, t, pi and the functions.
bool is_reserved_in_expressions(std::string_view name);

}  // namespace trajan
