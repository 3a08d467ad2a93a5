#include "client/particle_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "client/exit_code.h"
#include "client/gnuplot.h"
#include "client/private_server.h"
#include "client/projection.h"
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

/// The particles where they are to be drawn: displacements scaled, and the other half.
ParticlePicture placed(ParticlePicture particles, const RenderStyle& style) {
  if (style.deformation_scale != 1 && particles.displacement.empty()) {
    throw CommandError(ExitCode::not_found, "the snapshots have no displacements to scale",
                       "ask for them: outputs { snapshot_fields: DISPLACEMENT }");
  }
  for (std::size_t i = 0; i < particles.displacement.size(); ++i) {
    for (std::size_t axis : {0, 1, 2})
      particles.position[i][axis] += (style.deformation_scale - 1) * particles.displacement[i][axis];
  }
  if (!style.mirrored) return particles;
  if (particles.dimension != "axisymmetric")
    throw CommandError(ExitCode::usage, "only an axisymmetric scene can be mirrored");
  const std::size_t half = particles.position.size();
  for (std::size_t i = 0; i < half; ++i) {
    const Point at = particles.position[i];
    particles.position.push_back({-at[0], at[1], at[2]});
    particles.values.push_back(particles.values[i]);
  }
  return particles;
}

/// The distance to the nearest neighbour, in the median over a sample: the size of a particle.
double particle_spacing(const std::vector<Point>& points) {
  constexpr std::size_t most_samples = 200;
  std::vector<double> distances;
  const std::size_t stride = points.size() / most_samples + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j) {
      const Point &a = points[i], &b = points[j];
      if (i != j) nearest = std::min(nearest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
    distances.push_back(nearest);
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return std::isfinite(*middle) && *middle > 0 ? *middle : 1;
}

/// Viridis (van der Walt and Smith 2015): even steps of lightness, readable in grey and to all eyes.
constexpr const char* viridis =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4a89', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', "
    "6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";

/// What is seen: particles from the farthest to the nearest, as discs.
struct Scene {
  Projection projection;
  std::vector<Projected> discs;
  double radius = 0;
  bool in_space = false;
};

Scene scene_of(const ParticlePicture& particles, const RenderStyle& style) {
  constexpr double share = 0.71;  // of the spacing: discs on a square lattice leave no gap
  Scene scene;
  scene.in_space = particles.dimension == "solid";
  if (!scene.in_space && !style.view.empty())
    throw CommandError(ExitCode::usage, "only a solid can be looked at from elsewhere", "leave out --view");
  scene.radius = share * particle_spacing(particles.position);
  scene.projection = projection(!scene.in_space ? "z" : style.view.empty() ? "oblique" : style.view);
  scene.discs = project(particles.position, scene.projection);
  if (scene.in_space) scene.discs = without_hidden(scene.discs, scene.radius);
  return scene;
}

/// Pixels of the picture: room beside and around the axes, which are as wide as high in the particles' units.
struct Layout {
  static constexpr int left = 200, right = 330, bottom = 150, top = 110;
  int axes_width = 1400;
  int axes_height = 800;
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

/// A field without variation still needs a range, and so does one that no particle has.
void widen(Extent& values) {
  if (!(values.size() >= 0)) values = {0, 0};
  if (values.size() == 0) values.upper += std::max(std::abs(values.lower), 1.0) * 1e-3;
}

/// Writes `x y value` lines, to another file where there is no value. Returns what they span, with a margin
/// around the particles.
Window write_discs(const fs::path& coloured, const fs::path& grey, const Scene& scene,
                   const std::vector<double>& values) {
  Window window;
  std::ofstream with_value(coloured), without_value(grey);
  for (const Projected& disc : scene.discs) {
    const double value = values[disc.particle];
    window.x.include(disc.x);
    window.y.include(disc.y);
    if (!std::isnan(value)) window.value.include(value);
    (std::isnan(value) ? without_value : with_value)
        << fmt::format("{:.9g} {:.9g} {:.9g}\n", disc.x, disc.y, value);
  }
  const double margin = 0.03 * std::max(window.x.size(), window.y.size()) + scene.radius / 0.7;
  for (Extent* extent : {&window.x, &window.y}) {
    extent->lower -= margin;
    extent->upper += margin;
  }
  widen(window.value);
  return window;
}

std::string margins_script(const Layout& layout) {
  const double width = layout.width();
  const double height = layout.height();
  return fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n"
      "unset key\nset minussign\n",
      Layout::left / width, 1 - Layout::right / width, Layout::bottom / height, 1 - Layout::top / height);
}

std::string title_script(const ParticlePicture& particles, const RenderStyle& style, const UnitLabels& units) {
  std::string title = fmt::format("time {:.6g} {}", particles.time, units.time());
  if (style.deformation_scale != 1) title += fmt::format("  displacements × {:g}", style.deformation_scale);
  return fmt::format("set title {} noenhanced\n", gnuplot_text(title));
}

/// A round distance between tics, of which there are five at most.
double tic_distance(const Extent& extent) {
  const double least = extent.size() / 5, power = std::pow(10, std::floor(std::log10(least)));
  for (const double round : {1.0, 2.0, 5.0})
    if (round * power >= least) return round * power;
  return 10 * power;
}

std::string axis_label(std::string_view axis, const ParticlePicture& particles, const UnitLabels& units) {
  std::string name(axis);
  if (particles.dimension == "axisymmetric") name += axis == "x" ? ", radius" : ", axis";
  return with_unit(name, units.length());
}

/// Arrows along x, y and z in a corner instead of axes, and how far the particles reach along them.
std::string triad_script(const ParticlePicture& particles, const Scene& scene, const Layout& layout,
                         const UnitLabels& units) {
  constexpr double length = 90, label = 1.3;
  std::string script = "unset border\nunset xtics\nunset ytics\n";
  std::string reach;
  for (std::size_t axis : {0, 1, 2}) {
    const char name = "xyz"[axis];
    const double x = length * scene.projection.right[axis], y = length * scene.projection.up[axis];
    const auto place = [&](double share) {
      return fmt::format("screen {},{}", (110 + share * x) / layout.width(), (110 + share * y) / layout.height());
    };
    script += fmt::format("set arrow from {} to {} front linewidth 1.5\nset label '{}' at {} center front\n",
                          place(0), place(1), name, place(label));
    Extent extent;
    for (const Point& point : particles.position) extent.include(point[axis]);
    reach += fmt::format("{}{} {:.4g} to {:.4g}", axis > 0 ? ",  " : "", name, extent.lower, extent.upper);
  }
  return script + fmt::format("set label {} at screen {},{} noenhanced\n",
                              gnuplot_text(with_unit(reach, units.length())), 260.0 / layout.width(),
                              60.0 / layout.height());
}

void draw_discs(const ParticlePicture& particles, const RenderStyle& style, const fs::path& picture) {
  const Scene scene = scene_of(particles, style);
  const UnitLabels units(particles.units);
  const TemporaryFolder folder;
  const fs::path coloured = folder.path() / "coloured", grey = folder.path() / "grey";
  const Window window = write_discs(coloured, grey, scene, particles.values);
  const Layout layout = layout_of(window);
  const std::string value = with_unit(particles.label, units.of_column(particles.field));
  std::string script = gnuplot_opening(picture, layout.width(), layout.height());
  script.append(viridis).append(margins_script(layout)).append(title_script(particles, style, units));
  script += fmt::format(
      "set xrange [{}:{}]\nset yrange [{}:{}]\nset cbrange [{}:{}]\nunset grid\nset format cb '%.3h'\n"
      "set xtics {}\n"
      "set cblabel {} noenhanced offset 1.5\n",
      window.x.lower, window.x.upper, window.y.lower, window.y.upper, window.value.lower, window.value.upper,
      tic_distance(window.x), gnuplot_text(value));
  if (scene.projection.x_axis.empty()) {
    script += triad_script(particles, scene, layout, units);
  } else {
    script += fmt::format("set xlabel {} noenhanced\nset ylabel {} noenhanced\n",
                          gnuplot_text(axis_label(scene.projection.x_axis, particles, units)),
                          gnuplot_text(axis_label(scene.projection.y_axis, particles, units)));
  }
  const char* border = scene.in_space ? "border linecolor '#303030' linewidth 0.3" : "noborder";
  script += "plot ";
  if (fs::file_size(grey) > 0) {
    script += fmt::format("{} using 1:2:({}) with circles fillstyle solid 1.0 {} linecolor '#c8c8c8', ",
                          gnuplot_text(grey.string()), scene.radius, border);
  }
  script += fmt::format("{} using 1:2:({}):3 with circles fillstyle solid 1.0 {} linecolor palette\n",
                        gnuplot_text(coloured.string()), scene.radius, border);
  run_gnuplot(script, folder.path());
}

void draw_bar(const ParticlePicture& particles, const RenderStyle& style, const fs::path& picture) {
  const UnitLabels units(particles.units);
  const TemporaryFolder folder;
  const fs::path points = folder.path() / "points";
  Extent values;
  std::ofstream out(points);
  for (std::size_t i = 0; i < particles.values.size(); ++i) {
    if (std::isnan(particles.values[i])) continue;
    values.include(particles.values[i]);
    out << fmt::format("{:.9g} {:.9g}\n", particles.position[i][0], particles.values[i]);
  }
  out.close();
  widen(values);
  const double margin = 0.05 * values.size();
  const Layout layout;
  const std::string value = with_unit(particles.label, units.of_column(particles.field));
  std::string script = gnuplot_opening(picture, layout.width(), layout.height());
  script.append(margins_script(layout)).append(title_script(particles, style, units));
  script += fmt::format(
      "set xlabel {} noenhanced\nset ylabel {} noenhanced\nset yrange [{}:{}]\nset format y '%.4h'\n"
      "set autoscale xfix\nset offsets graph 0.02, graph 0.02\n"
      "plot {} using 1:2 with points pointtype 7 pointsize 0.9 linecolor '{}'\n",
      gnuplot_text(with_unit("x", units.length())), gnuplot_text(value), values.lower - margin,
      values.upper + margin, gnuplot_text(points.string()), line_colour(0));
  run_gnuplot(script, folder.path());
}

}  // namespace

void draw_particles(const ParticlePicture& particles, const RenderStyle& style, const fs::path& picture) {
  if (particles.values.empty()) throw CommandError(ExitCode::not_found, "the snapshot has no particles");
  const ParticlePicture shown = placed(particles, style);
  if (shown.dimension == "bar") {
    draw_bar(shown, style, picture);
  } else {
    draw_discs(shown, style, picture);
  }
}

}  // namespace trajan::client
