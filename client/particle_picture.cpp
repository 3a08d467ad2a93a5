#include "client/particle_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "client/exit_code.h"
#include "client/gnuplot.h"
#include "client/private_server.h"
#include "client/unit_labels.h"

namespace trajan::client {
namespace {

namespace fs = std::filesystem;

struct Extent {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();
  void include(double value) {
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
  double size() const { return upper - lower; }
};

/// Places to draw at, with displacements made larger or smaller.
std::vector<std::array<double, 2>> places(const ParticlePicture& particles, double scale) {
  std::vector<std::array<double, 2>> places = particles.position;
  if (scale == 1) return places;
  if (particles.displacement.empty()) {
    throw CommandError(ExitCode::not_found, "the snapshots have no displacements to scale",
                       "ask for them: outputs { snapshot_fields: DISPLACEMENT }");
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t axis : {0, 1}) places[i][axis] += (scale - 1) * particles.displacement[i][axis];
  }
  return places;
}

/// The distance to the nearest neighbour, in the median over a sample: the size of a particle.
double particle_spacing(const std::vector<std::array<double, 2>>& points) {
  constexpr std::size_t most_samples = 200;
  std::vector<double> distances;
  const std::size_t stride = points.size() / most_samples + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i != j)
        nearest = std::min(nearest, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
    }
    distances.push_back(nearest);
  }
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
                   distances.end());
  const double spacing = distances[distances.size() / 2];
  return std::isfinite(spacing) && spacing > 0 ? spacing : 1;
}

/// Viridis (van der Walt and Smith 2015): even steps of lightness, readable in grey and to all eyes.
constexpr const char* viridis =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4a89', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', "
    "6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";

std::string label_of(const std::string& field) {
  if (field == "stress") return "von Mises stress";
  if (field == "velocity") return "speed";
  if (field.find('.') == std::string::npos) return "magnitude of " + field;
  return field;
}

/// Room beside and around the axes, in pixels.
constexpr int left_margin = 200, right_margin = 330, bottom_margin = 150, top_margin = 110;

}  // namespace

void draw_particles(const ParticlePicture& particles, const RenderStyle& style, const fs::path& picture) {
  if (particles.values.empty()) throw CommandError(ExitCode::not_found, "the snapshot has no particles");
  const auto points = places(particles, style.deformation_scale);
  const double spacing = particle_spacing(points);
  const TemporaryFolder folder;
  const fs::path data = folder.path() / "particles";
  Extent x, y, value;
  {
    std::ofstream out(data);
    for (std::size_t i = 0; i < points.size(); ++i) {
      x.include(points[i][0]);
      y.include(points[i][1]);
      value.include(particles.values[i]);
      out << fmt::format("{:.9g} {:.9g} {:.9g}\n", points[i][0], points[i][1], particles.values[i]);
    }
  }
  const double margin = 0.03 * std::max(x.size(), y.size()) + spacing;
  const double aspect = (y.size() + 2 * margin) / (x.size() + 2 * margin);
  const int plot_width = std::clamp(static_cast<int>(1000 / aspect), 500, 1500);
  const int plot_height = std::max(static_cast<int>(plot_width * aspect), 160);
  const UnitLabels units(particles.units);
  std::string title = with_unit(fmt::format("time {:.6g}", particles.time), "");
  if (!units.time().empty()) title += " " + units.time();
  if (style.deformation_scale != 1) title += fmt::format(", displacements × {:g}", style.deformation_scale);
  // A field without variation still needs a range of colours.
  const double spread = value.size() > 0 ? 0 : std::max(std::abs(value.lower), 1.0) * 1e-3;
  std::string script =
      gnuplot_opening(picture, plot_width + left_margin + right_margin, plot_height + bottom_margin + top_margin);
  script += viridis;
  script += fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n",
      static_cast<double>(left_margin) / (plot_width + left_margin + right_margin),
      1 - static_cast<double>(right_margin) / (plot_width + left_margin + right_margin),
      static_cast<double>(bottom_margin) / (plot_height + bottom_margin + top_margin),
      1 - static_cast<double>(top_margin) / (plot_height + bottom_margin + top_margin));
  script += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset cbrange [{}:{}]\n", x.lower - margin,
                        x.upper + margin, y.lower - margin, y.upper + margin, value.lower - spread,
                        value.upper + spread);
  script += fmt::format(
      "unset grid\nunset key\nset format cb '%.3h'\nset colorbox\n"
      "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\nset cblabel {} noenhanced "
      "offset 1.5\n",
      gnuplot_text(title), gnuplot_text(with_unit("x", units.length())),
      gnuplot_text(with_unit("y", units.length())),
      gnuplot_text(with_unit(label_of(style.field), units.of_column(style.field))));
  script += fmt::format("plot {} using 1:2:({}):3 with circles fillstyle solid 1.0 noborder linecolor palette\n",
                        gnuplot_text(data.string()), 0.56 * spacing);
  run_gnuplot(script, folder.path());
}

}  // namespace trajan::client
