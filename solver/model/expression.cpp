#include "solver/model/expression.h"

#include <muParser.h>

#include <cctype>
#include <limits>
#include <numbers>
#include <vector>

#include "solver/model/names.h"

namespace trajan {

namespace {

constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
constexpr std::string_view digits = "0123456789";
constexpr std::string_view others = "+-*/^()<>=!&|?:,. \t\r\n";

bool contains(std::string_view set, char c) { return set.find(c) != std::string_view::npos; }

[[noreturn]] void fail(std::size_t position, const std::string& problem,
                       const std::string& remedy = "correct the formula") {
  throw FormulaError("at character " + std::to_string(position + 1) + ": " + problem, remedy);
}

/// Refuses what muParser would accept but a scene has no use for (assignments, strings), and what
/// would cost it much time or stack.
void check_characters(const std::string& text) {
  if (text.size() > Expression::longest) {
    throw FormulaError("the formula has " + std::to_string(text.size()) + " characters",
                       "give at most " + std::to_string(Expression::longest) + "; name parts of it as constants");
  }
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw FormulaError("the formula is empty", "give a number or a formula");
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!contains(letters, c) && !contains(digits, c) && !contains(others, c)) {
      fail(i, "formulas do not use this character");
    }
    if (c == ')') --depth;
    if ((c == '(' || c == '?') && ++depth > Expression::deepest) {
      fail(i, "parentheses and conditions are nested too deeply", "name parts of the formula as constants");
    };
    const bool comparison =
        (i > 0 && contains("<>=!", text[i - 1])) || (i + 1 < text.size() && text[i + 1] == '=');
    if (c == '=' && !comparison) fail(i, "a formula cannot assign", "compare with ==");
  }
}

struct Identifier {
  std::size_t position;
  std::string name;
};

/// All names in a formula. An exponent, as in 1e5, is part of a number and not a name.
std::vector<Identifier> identifiers(const std::string& text) {
  std::vector<Identifier> found;
  std::size_t i = 0;
  const auto skip = [&](std::string_view set) {
    while (i < text.size() && contains(set, text[i])) ++i;
  };
  while (i < text.size()) {
    const std::size_t begin = i;
    if (contains(letters, text[i])) {
      while (i < text.size() && (contains(letters, text[i]) || contains(digits, text[i]))) ++i;
      found.push_back({begin, text.substr(begin, i - begin)});
    } else if (contains(digits, text[i]) || text[i] == '.') {
      skip("0123456789.");
      std::size_t exponent = i + 1;
      if (exponent < text.size() && contains("+-", text[exponent])) ++exponent;
      if (i < text.size() && contains("eE", text[i]) && exponent < text.size() &&
          contains(digits, text[exponent])) {
        i = exponent;
        skip(digits);
      }
    } else {
      ++i;
    }
  }
  return found;
}

const mu::funmap_type& functions() {
  static const mu::Parser plain;
  return plain.GetFunDef();
}

[[noreturn]] void fail_unknown(const Identifier& unknown, const std::string& variables,
                               const Constants& constants) {
  std::vector<std::string> known = {"pi"};
  for (const char variable : variables) known.emplace_back(1, variable);
  for (const auto& [name, value] : constants) known.push_back(name);
  const std::string allowed = "besides functions the formula may use " + list_of(known);
  for (const auto& [name, callback] : functions()) known.push_back(name);
  const std::string hint = did_you_mean(unknown.name, known);
  fail(unknown.position, quoted(unknown.name) + " has no meaning here",
       hint.empty() ? allowed : hint + " (" + allowed + ")");
}

/// muParser counts characters from 0 and says so at the end of its message.
[[noreturn]] void fail_unreadable(const mu::ParserError& error) {
  std::string said = error.GetMsg();
  for (const char* place : {" found at position ", " at position "}) said = said.substr(0, said.find(place));
  if (said.ends_with('.')) said.pop_back();
  said[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(said[0])));
  const auto position = static_cast<std::size_t>(error.GetPos());
  if (error.GetPos() < 0) throw FormulaError("not a formula: " + shortened(said));
  fail(position, shortened(said));
}

}  // namespace

bool is_reserved_in_expressions(std::string_view name) {
  return name == "x" || name == "y" || name == "z" || name == "t" || name == "pi" ||
         functions().contains(std::string(name));
}

struct Expression::Parser {
  std::string text;
  std::string variables;
  Constants constants;  ///< those that the formula uses
  double x = 0, y = 0, z = 0, t = 0;
  mu::Parser parser;

  Parser(const std::string& formula, const std::string& allowed, const Constants& all)
      : text(formula), variables(allowed) {
    check_characters(text);
    parser.ClearConst();
    parser.DefineConst("pi", std::numbers::pi);
    if (contains(variables, 'x')) parser.DefineVar("x", &x);
    if (contains(variables, 'y')) parser.DefineVar("y", &y);
    if (contains(variables, 'z')) parser.DefineVar("z", &z);
    if (contains(variables, 't')) parser.DefineVar("t", &t);
    for (const Identifier& identifier : identifiers(text)) define(identifier, all);
    compile();
  }

  void define(const Identifier& identifier, const Constants& all) {
    const std::string& name = identifier.name;
    if (const auto constant = all.find(name); constant != all.end()) {
      if (constants.emplace(name, constant->second).second) parser.DefineConst(name, constant->second);
    } else if (name != "pi" && !functions().contains(name) && !parser.GetVar().contains(name)) {
      fail_unknown(identifier, variables, all);
    }
  }

  /// muParser parses when it first evaluates.
  void compile() {
    try {
      parser.SetExpr(text);
      parser.Eval();
    } catch (const mu::ParserError& error) {
      fail_unreadable(error);
    }
    if (parser.GetNumResults() != 1) throw FormulaError("a formula has one value, not several");
  }
};

Expression::Expression(const std::string& text, const std::string& variables, const Constants& constants)
    : parser_(std::make_unique<Parser>(text, variables, constants)) {}

Expression::Expression(const Expression& other)
    : parser_(std::make_unique<Parser>(other.parser_->text, other.parser_->variables, other.parser_->constants)) {}

Expression::Expression(Expression&&) noexcept = default;
Expression::~Expression() = default;

Expression& Expression::operator=(Expression other) noexcept {
  parser_ = std::move(other.parser_);
  return *this;
}

double Expression::operator()(Vector at, double t) const {
  parser_->x = at.x;
  parser_->y = at.y;
  parser_->z = at.z;
  parser_->t = t;
  try {
    return parser_->parser.Eval();
  } catch (const mu::ParserError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

const std::string& Expression::text() const { return parser_->text; }

}  // namespace trajan
