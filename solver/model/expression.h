#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace trajan {

/// Values that expressions may use by name.
using Constants = std::map<std::string, double>;

/// A formula of x, y and t in muParser syntax, `pi` and the scene's constants included. Copies share
/// nothing that changes; one object must not be evaluated by two threads at once.
class Expression {
 public:
  static constexpr std::size_t longest = 1024;  ///< characters; muParser takes time with their square
  static constexpr int deepest = 64;            ///< nested parentheses and conditions

  /// `variables`: the letters of "xyt" that the formula may use.
  /// Throws std::invalid_argument whose text says what is wrong and where in the formula.
  Expression(const std::string& text, const std::string& variables, const Constants& constants);
  Expression(const Expression& other);
  Expression(Expression&& other) noexcept;
  Expression& operator=(Expression other) noexcept;
  ~Expression();

  /// Not finite where the formula is not defined; never throws.
  double operator()(double x, double y, double t) const;
  const std::string& text() const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// Whether formulas give this name a meaning of their own: x, y, z, t, pi and the functions.
bool is_reserved_in_expressions(std::string_view name);

}  // namespace trajan
