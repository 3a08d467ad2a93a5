#include "client/gnuplot.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "client/exit_code.h"
#include "client/subprocess.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

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

}  // namespace trajan::client
