#include "client/trade_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <vector>

#include "client/exit_code.h"
#include "client/gnuplot.h"
#include "client/private_server.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

using Points = std::vector<std::pair<double, double>>;  ///< core-seconds and errors

/// An error of zero has no place on a logarithmic axis.
bool can_be_drawn(const v1::Run& run) {
  return run.has_error() && run.error() > 0 && run.cost().core_seconds() > 0;
}

struct Line {
  Points points;
  bool is_best = false;  ///< somewhere, of all
};

/// Of each method; runs come in the order of the cell sizes.
std::map<std::string, Line> lines_of(const v1::Study& study) {
  std::map<std::string, Line> lines;
  for (const v1::Run& run : study.runs()) {
    if (!can_be_drawn(run)) continue;
    std::string method;
    for (int dial = 0; dial < study.dials_size(); ++dial) {
      if (study.dials(dial) != "domain.cell_size") method += (method.empty() ? "" : ", ") + run.settings(dial);
    }
    Line& line = lines[method];
    line.points.emplace_back(run.cost().core_seconds(), run.error());
    line.is_best |= run.pareto();
  }
  return lines;
}

/// Methods that are best somewhere are drawn boldly, the others thinly and dashed.
std::string curve_of(const fs::path& file, const std::string& method, const Line& line, std::size_t number) {
  return fmt::format(
      ", \\\n  {} with linespoints linewidth {} dashtype {} pointtype {} pointsize {} linecolor '{}' title {}",
      gnuplot_text(file.string()), line.is_best ? 4 : 1.2, line.is_best ? 1 : 2, 4 + number / 7 * 2 + number % 2,
      line.is_best ? 1.5 : 0.9, line_colour(number), gnuplot_text(method));
}

Points pareto_set(const v1::Study& study) {
  Points points;
  for (const v1::Run& run : study.runs()) {
    if (can_be_drawn(run) && run.pareto()) points.emplace_back(run.cost().core_seconds(), run.error());
  }
  std::ranges::sort(points);
  return points;
}

void write_points(const fs::path& file, const Points& points) {
  std::ofstream out(file);
  for (const auto& [cost, error] : points) out << fmt::format("{:.9g} {:.9g}\n", cost, error);
}

}  // namespace

void draw_trade(const v1::Study& study, const fs::path& picture) {
  const auto lines = lines_of(study);
  if (lines.empty()) throw CommandError(ExitCode::not_found, "no run of the study has an error to be drawn");
  const TemporaryFolder folder;
  write_points(folder.path() / "pareto", pareto_set(study));
  std::string curves = fmt::format("plot {} with lines linewidth 14 linecolor '#e4e4e4' title 'best of all'",
                                   gnuplot_text((folder.path() / "pareto").string()));
  std::size_t number = 0;
  for (const auto& [method, line] : lines) {
    const fs::path file = folder.path() / fmt::format("curve{}", number);
    write_points(file, line.points);
    curves += curve_of(file, method, line, number++);
  }
  const bool relative = study.trade().reference() != 0;
  run_gnuplot(
      gnuplot_opening(picture, 1800, 1100) +
          fmt::format("set logscale xy\nset format x '10^{{%L}}'\nset format y '10^{{%L}}'\n"
                      "set key outside right Left reverse noenhanced font ',18'\nset title {} noenhanced\n"
                      "set xlabel 'core-seconds'\nset ylabel {} noenhanced\n",
                      gnuplot_text(study.job().scene_name()),
                      gnuplot_text((relative ? "relative error of " : "error of ") + study.trade().measure())) +
          curves + "\n",
      folder.path());
}

}  // namespace trajan::client
