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

/// Pixels of the picture: room beside and around the axes, which are as wide as high in the particles' units.
struct Layout {
  static constexpr int left = 200, right = 330, bottom = 150, top = 110;
  int axes_width = 0;
  int axes_height = 0;
  int width() const { return axes_width + left + right; }
  int height() const { return axes_height + bottom + top; }
};

struct Window {
  Extent x, y, value;
};

Layout layout_of(const Window& window) {
  constexpr int shortest = 160;
  const double aspect = window.y.size() / window.x.size();
  Layout layout;
  layout.axes_width = std::clamp(static_cast<int>(1000 / aspect), 500, 1500);
  layout.axes_height = std::max(static_cast<int>(layout.axes_width * aspect), shortest);
  return layout;
}

/// Writes `x y value` lines. Returns what they span, with a margin around the particles.
Window write_particles(const fs::path& file, const std::vector<std::array<double, 2>>& points,
                       const std::vector<double>& values, double spacing) {
  Window window;
  std::ofstream out(file);
  for (std::size_t i = 0; i < points.size(); ++i) {
    window.x.include(points[i][0]);
    window.y.include(points[i][1]);
    window.value.include(values[i]);
    out << fmt::format("{:.9g} {:.9g} {:.9g}\n", points[i][0], points[i][1], values[i]);
  }
  const double margin = 0.03 * std::max(window.x.size(), window.y.size()) + spacing;
  for (Extent* extent : {&window.x, &window.y}) {
    extent->lower -= margin;
    extent->upper += margin;
  }
  // A field without variation still needs a range of colours.
  if (window.value.size() == 0) window.value.upper += std::max(std::abs(window.value.lower), 1.0) * 1e-3;
  return window;
}

std::string axes_script(const Window& window, const Layout& layout) {
  const double width = layout.width();
  const double height = layout.height();
  return fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\nset cbrange [{}:{}]\n"
      "unset grid\nunset key\nset minussign\nset format cb '%.3h'\n",
      Layout::left / width, 1 - Layout::right / width, Layout::bottom / height, 1 - Layout::top / height,
      window.x.lower, window.x.upper, window.y.lower, window.y.upper, window.value.lower, window.value.upper);
}

std::string labels_script(const ParticlePicture& particles, const RenderStyle& style) {
  const UnitLabels units(particles.units);
  std::string title = fmt::format("time {:.6g} {}", particles.time, units.time());
  if (style.deformation_scale != 1) title += fmt::format("  displacements × {:g}", style.deformation_scale);
  return fmt::format(
      "set title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n"
      "set cblabel {} noenhanced offset 1.5\n",
      gnuplot_text(title), gnuplot_text(with_unit("x", units.length())),
      gnuplot_text(with_unit("y", units.length())),
      gnuplot_text(with_unit(label_of(style.field), units.of_column(style.field))));
}

}  // namespace

void draw_particles(const ParticlePicture& particles, const RenderStyle& style, const fs::path& picture) {
  constexpr double radius = 0.71;  // of the spacing: discs on a square lattice leave no gap
  if (particles.values.empty()) throw CommandError(ExitCode::not_found, "the snapshot has no particles");
  const auto points = places(particles, style.deformation_scale);
  const double spacing = particle_spacing(points);
  const TemporaryFolder folder;
  const fs::path data = folder.path() / "particles";
  const Window window = write_particles(data, points, particles.values, spacing);
  const Layout layout = layout_of(window);
  const std::string plot =
      fmt::format("plot {} using 1:2:({}):3 with circles fillstyle solid 1.0 noborder linecolor palette\n",
                  gnuplot_text(data.string()), radius * spacing);
  std::string script = gnuplot_opening(picture, layout.width(), layout.height());
  script.append(viridis).append(axes_script(window, layout)).append(labels_script(particles, style)).append(plot);
  run_gnuplot(script, folder.path());
}

}  // namespace trajan::client
