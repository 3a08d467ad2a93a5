#include "client/gnuplot.h"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <map>
#include <sstream>

#include "client/exit_code.h"
#include "client/subprocess.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

/// What muParser's words are called in gnuplot.
const std::map<std::string, std::string, std::less<>>& known_words() {
  static const std::map<std::string, std::string, std::less<>> words{
      {"sin", "sin"},     {"cos", "cos"},     {"tan", "tan"},     {"asin", "asin"}, {"acos", "acos"},
      {"atan", "atan"},   {"atan2", "atan2"}, {"sinh", "sinh"},   {"cosh", "cosh"}, {"tanh", "tanh"},
      {"asinh", "asinh"}, {"acosh", "acosh"}, {"atanh", "atanh"}, {"exp", "exp"},   {"log", "log"},
      {"ln", "log"},      {"log10", "log10"}, {"sqrt", "sqrt"},   {"abs", "abs"},   {"sign", "sgn"},
      {"pi", "pi"},       {"_pi", "pi"},      {"_e", "exp(1.0)"}, {"t", "x"}};
  return words;
}

bool is_word_part(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_'; }

/// The end of the number that begins at `begin`: digits, one point, an exponent.
std::size_t number_end(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size()) {
    const bool exponent_sign =
        (text[end] == '+' || text[end] == '-') && (text[end - 1] == 'e' || text[end - 1] == 'E');
    if (!std::isalnum(static_cast<unsigned char>(text[end])) && text[end] != '.' &&
        !(end > begin && exponent_sign))
      break;
    ++end;
  }
  return end;
}

bool is_constant(std::string_view word, const v1::Scene& scene) {
  for (const v1::Constant& constant : scene.constants()) {
    if (constant.name() == word) return true;
  }
  return false;
}

std::string terminal(const fs::path& picture, int width, int height) {
  const std::string suffix = picture.extension().string();
  if (suffix == ".png")
    return fmt::format("pngcairo enhanced size {},{} font 'DejaVu Sans,24' linewidth 2", width, height);
  if (suffix == ".svg")
    return fmt::format("svg enhanced size {},{} font 'DejaVu Sans,24' linewidth 2 background '#ffffff'", width,
                       height);
  if (suffix == ".pdf") {
    return fmt::format("pdfcairo enhanced size {}in,{}in font 'DejaVu Sans,12' linewidth 1", width / 200.0,
                       height / 200.0);
  }
  throw CommandError(ExitCode::usage, fmt::format("\"{}\" is not a kind of picture that can be drawn", suffix),
                     "use a name that ends in .png, .svg or .pdf");
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (letter == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return quoted + "'";
}

std::string gnuplot_opening(const fs::path& picture, int width, int height) {
  return fmt::format(
      "set terminal {}\n"
      "set output {}\n"
      "set encoding utf8\n"
      "set samples 4000\n"
      "set border linewidth 1 linecolor '#404040'\n"
      "set tics nomirror textcolor '#202020'\n"
      "set grid linecolor '#d8d8d8' linetype 1 linewidth 0.6\n",
      terminal(picture, width, height), gnuplot_text(fs::absolute(picture).string()));
}

std::string_view line_colour(std::size_t number) {
  static constexpr std::string_view colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#7f7f7f"};
  return colours[number % std::size(colours)];
}

void run_gnuplot(const std::string& script, const fs::path& folder) {
  const auto gnuplot = find_program("gnuplot");
  if (!gnuplot) {
    throw CommandError(ExitCode::local_failure, "gnuplot, which draws the pictures, is missing",
                       "apt-get install gnuplot-nox");
  }
  const fs::path file = folder / "script.gnuplot";
  const fs::path log = folder / "gnuplot.log";
  std::ofstream(file) << script;
  ChildProcess process(*gnuplot, {file.string()}, log);
  if (process.wait() == 0) return;
  std::ostringstream said;
  said << std::ifstream(log).rdbuf();
  throw CommandError(ExitCode::local_failure, "gnuplot could not draw the picture: " + said.str());
}

std::optional<std::string> gnuplot_expression(std::string_view expression, const v1::Scene& scene) {
  std::string translated;
  for (std::size_t i = 0; i < expression.size();) {
    const char letter = expression[i];
    if (std::isdigit(static_cast<unsigned char>(letter)) || letter == '.') {
      const std::size_t end = number_end(expression, i);
      const std::string number(expression.substr(i, end - i));
      // 1/2 is a whole-number division in gnuplot.
      translated += number.find_first_of(".eE") == std::string::npos ? number + ".0" : number;
      i = end;
    } else if (is_word_part(letter)) {
      std::size_t end = i;
      while (end < expression.size() && is_word_part(expression[end])) ++end;
      const std::string_view word = expression.substr(i, end - i);
      const auto known = known_words().find(word);
      const bool constant = is_constant(word, scene);
      if (!constant && known == known_words().end()) return std::nullopt;
      translated += constant ? "constant_" + std::string(word) : known->second;
      i = end;
    } else {
      if (std::string_view(" \t\n+-*/^(),").find(letter) == std::string_view::npos) return std::nullopt;
      translated += letter == '^' ? "**" : letter == '\n' ? " " : std::string(1, letter);
      ++i;
    }
  }
  return translated;
}

std::optional<std::string> gnuplot_constants(const v1::Scene& scene) {
  std::string definitions;
  for (const v1::Constant& constant : scene.constants()) {
    const auto value = gnuplot_expression(constant.value(), scene);
    if (!value) return std::nullopt;
    definitions += fmt::format("constant_{} = {}\n", constant.name(), *value);
  }
  return definitions;
}

}  // namespace trajan::client
