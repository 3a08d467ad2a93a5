#include "client/history_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "client/gnuplot.h"
#include "client/private_server.h"
#include "client/spectrum.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

/// Curves that share a vertical axis.
struct Panel {
  std::string label;  ///< of the vertical axis
  std::vector<std::size_t> columns;
};

/// What a column shows, without whose and which component: `tip.velocity.x` shows "velocity", `tip.damage`
/// "damage".
std::string kind_of(const std::string& column) {
  const std::size_t first = column.find('.');
  const std::size_t last = column.rfind('.');
  if (first == std::string::npos) return column;
  const std::string group = column.substr(0, first);
  if (column == "energies.balance_error") return "energy balance error";
  if (group == "energies") return "energy";
  if (group == "momentum") return group;
  if (group == "reactions") return "reaction";
  std::string kind = column.substr(first + 1, first == last ? std::string::npos : last - first - 1);
  std::ranges::replace(kind, '_', ' ');
  return kind;
}

std::vector<Panel> panels_of(const History& history, const PictureNotes& notes) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < history.columns.size(); ++i) {
    const std::string label = with_unit(kind_of(history.columns[i]), notes.units.of_column(history.columns[i]));
    auto panel = std::find_if(panels.begin(), panels.end(), [&](const Panel& p) { return p.label == label; });
    if (panel == panels.end()) panel = panels.insert(panels.end(), Panel{label, {}});
    panel->columns.push_back(i);
  }
  return panels;
}

/// Curves as columns of text: `x y`, one file each.
void write_curve(const fs::path& file, std::span<const double> x, std::span<const double> y) {
  std::ofstream out(file);
  for (std::size_t i = 0; i < x.size(); ++i) out << fmt::format("{:.9g} {:.9g}\n", x[i], y[i]);
}

/// The smallest and largest value of each stretch: what a picture can show of a long history.
void write_thinned(const fs::path& file, std::span<const double> x, std::span<const double> y) {
  constexpr std::size_t most_points = 8000;  // a few for each pixel
  if (x.size() <= most_points) return write_curve(file, x, y);
  std::vector<double> thin_x;
  std::vector<double> thin_y;
  const std::size_t stretch = 2 * x.size() / most_points + 1;
  for (std::size_t begin = 0; begin < x.size(); begin += stretch) {
    const auto piece = y.subspan(begin, std::min(stretch, x.size() - begin));
    const auto [smallest, largest] = std::minmax_element(piece.begin(), piece.end());
    for (const auto point : {std::min(smallest, largest), std::max(smallest, largest)}) {
      thin_x.push_back(x[begin + static_cast<std::size_t>(point - piece.begin())]);
      thin_y.push_back(*point);
    }
  }
  write_curve(file, thin_x, thin_y);
}

std::string curve_file(const fs::path& folder, std::size_t column) {
  return (folder / fmt::format("curve{}", column)).string();
}

std::string exact_file(const fs::path& folder, std::size_t number) {
  return (folder / fmt::format("exact{}", number)).string();
}

/// `plot …` for one panel: the curves, then what is exact, dashed in black on top.
std::string plot_command(const Panel& panel, const History& history, const PictureNotes& notes,
                         const fs::path& folder) {
  std::vector<std::string> items;
  std::size_t colour = 0;
  for (const std::size_t column : panel.columns) {
    items.push_back(fmt::format("{} using 1:2 with lines linewidth 2.5 linecolor '{}' title {} noenhanced",
                                gnuplot_text(curve_file(folder, column)), line_colour(colour++),
                                gnuplot_text(history.columns[column])));
  }
  const auto shown = [&](const ExactHistory& exact) {
    return std::ranges::any_of(panel.columns, [&](std::size_t c) { return history.columns[c] == exact.column; });
  };
  const bool several = std::ranges::count_if(notes.exact, shown) > 1;
  static constexpr std::string_view dashes[] = {"(10,8)", "(3,6)", "(12,5,3,5)", "(20,6)"};
  std::size_t dash = 0;
  for (std::size_t i = 0; i < notes.exact.size(); ++i) {
    if (!shown(notes.exact[i])) continue;
    items.push_back(fmt::format("{} using 1:2 with lines linewidth 1.2 linecolor '#000000' dashtype {} title {}",
                                gnuplot_text(exact_file(folder, i)), dashes[dash++ % std::size(dashes)],
                                gnuplot_text(several ? "exact " + notes.exact[i].measure : "exact")));
  }
  return fmt::format("plot {}\n", fmt::join(items, ", \\\n     "));
}

/// All panels above each other with one horizontal axis.
std::string panels_script(const std::vector<Panel>& panels, const std::string& x_label,
                          const std::vector<std::string>& commands) {
  std::string script = fmt::format(
      "set multiplot layout {},1\n"
      "set lmargin at screen 0.15\nset rmargin at screen 0.96\n"
      "set key outside top left horizontal Left reverse noenhanced samplen 2 spacing 1.1 width 2\n"
      "set format y '%.7h'\nset minussign\nset offsets 0, 0, graph 0.05, graph 0.05\n",
      panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const bool last = i + 1 == panels.size();
    // A label at a fixed place, so that the panels' labels stand in one line.
    script += fmt::format(
        "set label 1 {} at screen 0.025, graph 0.5 center rotate noenhanced\nset xlabel {} noenhanced\n",
        gnuplot_text(panels[i].label), gnuplot_text(last ? x_label : ""));
    script += commands[i];
  }
  return script + "unset multiplot\n";
}

int picture_height(std::size_t panels) { return std::max(1000, 200 + 500 * static_cast<int>(panels)); }

void require_rows(const History& history, std::size_t least) {
  if (history.columns.empty() || history.time.size() < least) {
    throw CommandError(ExitCode::not_found, fmt::format("there are {} rows of {} columns: too few to draw",
                                                        history.time.size(), history.columns.size()));
  }
}

/// Amplitudes below this share of the highest are not drawn.
constexpr double smallest_share = 1e-6;

/// The frequency up to which a spectrum is worth drawing.
double highest_visible(const Spectrum& spectrum) {
  constexpr std::size_t fewest_bins = 20;
  const double peak = *std::max_element(spectrum.amplitude.begin(), spectrum.amplitude.end());
  std::size_t last = spectrum.amplitude.size() - 1;
  while (last > fewest_bins && spectrum.amplitude[last] < 1e-4 * peak) --last;
  return spectrum.frequency[std::min(2 * last, spectrum.frequency.size() - 1)];
}

}  // namespace

PictureNotes picture_notes(const v1::Job& job) {
  PictureNotes notes;
  notes.units = UnitLabels(job.scene().units());
  notes.exact = exact_histories(job);
  return notes;
}

History select_measured(const History& history, const v1::Job& job) {
  std::set<std::string> wanted;
  for (const v1::MeasureValue& measure : job.measures()) wanted.insert(measure.quantity());
  History selected;
  selected.time = history.time;
  for (std::size_t i = 0; i < history.columns.size(); ++i) {
    const std::string& column = history.columns[i];
    const bool of_all = column.starts_with("energies.") || column.starts_with("momentum.");
    if (wanted.empty() ? of_all : !wanted.contains(column)) continue;
    selected.columns.push_back(column);
    selected.values.push_back(history.values[i]);
  }
  return selected;
}

void draw_histories(const History& history, const PictureNotes& notes, const fs::path& picture) {
  require_rows(history, 2);
  const TemporaryFolder folder;
  for (std::size_t i = 0; i < history.columns.size(); ++i) {
    write_thinned(curve_file(folder.path(), i), history.time, history.values[i]);
  }
  for (std::size_t i = 0; i < notes.exact.size(); ++i) {
    write_curve(exact_file(folder.path(), i), notes.exact[i].time, notes.exact[i].value);
  }
  const std::vector<Panel> panels = panels_of(history, notes);
  std::vector<std::string> commands;
  for (const Panel& panel : panels) commands.push_back(plot_command(panel, history, notes, folder.path()));
  run_gnuplot(gnuplot_opening(picture, 1600, picture_height(panels.size())) +
                  fmt::format("set xrange [{}:{}]\n", history.time.front(), history.time.back()) +
                  panels_script(panels, with_unit("time", notes.units.time()), commands),
              folder.path());
}

void draw_spectra(const History& history, const PictureNotes& notes, const fs::path& picture) {
  require_rows(history, 4);
  const TemporaryFolder folder;
  double highest = 0;
  double peak = 0;
  for (std::size_t i = 0; i < history.columns.size(); ++i) {
    const Spectrum spectrum = amplitude_spectrum(history.time, history.values[i]);
    write_curve(curve_file(folder.path(), i), spectrum.frequency, spectrum.amplitude);
    highest = std::max(highest, highest_visible(spectrum));
    peak = std::max(peak, *std::max_element(spectrum.amplitude.begin(), spectrum.amplitude.end()));
  }
  std::vector<Panel> panels = panels_of(history, notes);
  std::vector<std::string> commands;
  PictureNotes without_exact;
  for (Panel& panel : panels) {
    panel.label = "amplitude of " + panel.label;
    commands.push_back(plot_command(panel, history, without_exact, folder.path()));
  }
  const std::string unit = notes.units.time() == "s"    ? "Hz"
                           : notes.units.time().empty() ? ""
                                                        : "1/" + notes.units.time();
  run_gnuplot(
      gnuplot_opening(picture, 1600, picture_height(panels.size())) +
          fmt::format("set xrange [0:{}]\nset yrange [{}:*]\nset logscale y\n", highest, smallest_share * peak) +
          panels_script(panels, with_unit("frequency", unit), commands),
      folder.path());
}

}  // namespace trajan::client
