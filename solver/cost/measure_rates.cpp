#include "solver/cost/measure_rates.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>

#include "solver/cost/run_time.h"
#include "solver/cost/sample_scenes.h"
#include "solver/model/validate.h"
#include "solver/schemes/scheme.h"
#include "solver/simulation/simulation.h"
#include "solver/transfers/transfer.h"

namespace trajan {
namespace {

constexpr Dimension dimensions[] = {Dimension::bar, Dimension::plane_stress, Dimension::plane_strain,
                                    Dimension::axisymmetric, Dimension::solid};
/// Those whose grids differ.
constexpr Dimension grids[] = {Dimension::bar, Dimension::plane_strain, Dimension::axisymmetric, Dimension::solid};
/// Measurements that `measure_rates` takes, about.
constexpr double measurements = 1150;

double clock_seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What a step of a scene takes, and what it consists of.
struct Sample {
  double seconds = 0;
  StepSize size;
};

class Measuring {
 public:
  explicit Measuring(double seconds) : slice_(seconds / measurements) {}

  Rates rates() {
    for (Dimension grid : grids) {
      for (std::string_view shape : shape_names()) {
        for (std::string_view scheme : scheme_names()) measure_steps(grid, shape, scheme);
        measure_transfers(grid, shape);
        measure_iterations(grid, shape);
        measure_contact(grid, shape);
      }
    }
    for (Dimension dimension : dimensions) {
      for (bool total : {false, true}) measure_laws(dimension, total);
      measure_tangents(dimension);
    }
    measure_modes();
    measure_formulas();
    measure_memory();
    measure_waiting();
    return std::move(rates_);
  }

 private:
  static const MaterialKind& elastic() { return *find_material_kind("linear_elastic"); }
  /// Cells along a side of a block of a few tiles, and of one of a thousand particles.
  static int several_tiles(Dimension grid) {
    return grid == Dimension::bar ? 640 : grid == Dimension::solid ? 8 : 24;
  }
  static int small(Dimension grid) { return grid == Dimension::bar ? 256 : grid == Dimension::solid ? 5 : 16; }

  static Scene block(Dimension dimension, int cells, int particles, const MaterialKind& kind = elastic()) {
    return sample_block(dimension, kind, cells, particles);
  }

  /// Of steps after the first; nothing if the scene is not allowed. The fastest of three series counts: what
  /// disturbs only delays.
  std::optional<Sample> time_steps(const Scene& scene, int threads = 1) const {
    try {
      const Model model = validate(scene);
      Simulation simulation(model, threads);
      simulation.step();
      Sample sample;
      sample.size = step_size(model, plan(model));
      sample.seconds = HUGE_VAL;
      for (int series = 0; series < 3; ++series)
        sample.seconds = std::min(sample.seconds, time_series(simulation, threads));
      return sample;
    } catch (const InvalidScene&) {
      return std::nullopt;
    }
  }

  double time_series(Simulation& simulation, int threads) const {
    const clockid_t clock = threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC;
    const double begin = clock_seconds(clock);
    double elapsed = 0;
    std::int64_t steps = 0;
    for (std::int64_t more = 1; elapsed < slice_ / 3; more = steps) {
      for (std::int64_t i = 0; i < more; ++i) simulation.step();
      steps += more;
      elapsed = clock_seconds(clock) - begin;
    }
    return elapsed / static_cast<double>(steps);
  }

  void keep(const std::string& name, double seconds) { rates_[name] = std::max(seconds, 0.0); }

  /// Three blocks tell a step, its tiles and its particles apart.
  void measure_steps(Dimension grid, std::string_view shape, std::string_view scheme) {
    Numerics numerics;
    numerics.shape_functions = shape;
    numerics.scheme = scheme;
    const auto time = [&](int cells, int particles) {
      Scene scene = block(grid, cells, particles);
      scene.numerics = numerics;
      return time_steps(scene);
    };
    const auto single = time(1, 1), few = time(several_tiles(grid), 1), many = time(several_tiles(grid), 2);
    if (!few || !many) return;
    const double particle =
        std::max(0.0, (many->seconds - few->seconds) / (many->size.particles - few->size.particles));
    const double rest = few->seconds - particle * few->size.particles;
    const double first = single ? single->seconds - particle : 0;
    const double single_tiles = single ? single->size.tiles : 0;
    const double tile = std::max(0.0, (rest - first) / (few->size.tiles - single_tiles));
    keep(step_rate(grid, numerics, "particle"), particle);
    keep(step_rate(grid, numerics, "tile"), tile);
    keep(step_rate(grid, numerics, "step"), rest - tile * few->size.tiles);
  }

  /// What a scene's steps take more than those of another one, per particle; nothing if it is not allowed.
  std::optional<double> excess(const Scene& scene, const std::optional<Sample>& plain) const {
    const auto sample = time_steps(scene);
    if (!plain || !sample) return std::nullopt;
    return (sample->seconds - plain->seconds) / sample->size.particles;
  }

  void measure_transfers(Dimension grid, std::string_view shape) {
    constexpr int orders = 3;
    Scene scene = block(grid, small(grid), 2);
    scene.numerics.shape_functions = shape;
    const auto plain = time_steps(scene);
    for (std::string_view transfer : transfer_names()) {
      if (!plain || transfer == Numerics{}.transfer) continue;
      scene.numerics.transfer = transfer;
      const bool ordered = find_transfer(transfer)->ordered;
      for (int order = 1; order <= (ordered ? orders : 1); ++order) {
        scene.numerics.transfer_order = ordered ? std::optional(order) : std::nullopt;
        if (const auto more = excess(scene, plain)) rates_[transfer_rate(grid, scene.numerics)] = *more;
      }
    }
  }

  void measure_contact(Dimension grid, std::string_view shape) {
    Scene contact = sample_contact(grid, elastic(), small(grid), 2);
    contact.numerics.shape_functions = shape;
    Scene stuck = contact;
    stuck.contacts.clear();
    const auto together = time_steps(contact), one = time_steps(stuck);
    if (together && one)
      keep(contact_rate(grid, shape), (together->seconds - one->seconds) / together->size.layer);
  }

  void measure_laws(Dimension dimension, bool total) {
    const Dimension grid = dimension == Dimension::plane_stress ? Dimension::plane_strain : dimension;
    const char* scheme = total ? "TLMPM" : "MUSL";
    Scene scene = block(grid, small(grid), 2);
    scene.numerics.scheme = scheme;
    const auto plain = time_steps(scene);
    for (std::span<const MaterialKind> kinds : {material_kinds(), damaged_kinds()})
      for (const MaterialKind& kind : kinds) {
        Scene other = block(dimension, small(grid), 2, kind);
        other.numerics.scheme = scheme;
        const auto steps = time_steps(other);
        if (!plain || !steps) continue;
        rates_[law_rate(dimension, total, kind.name)] = (steps->seconds - plain->seconds) / steps->size.particles;
        other.outputs.samples = 1'000'000;  // more than steps
        other.analysis.end_time = 1;
        if (const auto more = excess(other, steps)) keep(sample_rate(dimension, total, kind.name), *more);
      }
  }

  static Scene implicit_block(Dimension dimension, int cells, const MaterialKind& kind) {
    Scene scene = block(dimension, cells, 2, kind);
    scene.numerics.scheme = "TLMPM";
    scene.analysis.kind = ImplicitDynamics{};
    return scene;
  }

  void measure_tangents(Dimension dimension) {
    const int cells = small(dimension);
    const auto plain = time_steps(implicit_block(dimension, cells, *find_material_kind("neo_hookean")));
    for (std::span<const MaterialKind> kinds : {material_kinds(), damaged_kinds()})
      for (const MaterialKind& kind : kinds)
        if (const auto more = excess(implicit_block(dimension, cells, kind), plain))
          rates_[tangent_rate(dimension, kind.name)] = *more;
  }

  /// Two blocks tell assembly and factorization apart.
  void measure_iterations(Dimension grid, std::string_view shape) {
    const int large = grid == Dimension::bar ? 640 : grid == Dimension::solid ? 4 : 24;
    const auto time = [&](int cells) {
      Scene scene = implicit_block(grid, cells, *find_material_kind("neo_hookean"));
      scene.numerics.shape_functions = shape;
      return time_steps(scene);
    };
    const auto few = time(large / 2), many = time(large);
    if (!few || !many) return;
    const double ratio = many->size.particles / few->size.particles;
    const double factors = std::max(
        0.0, (many->seconds - ratio * few->seconds) / (many->size.factor_work - ratio * few->size.factor_work));
    keep(iteration_rate(grid, shape, "factors"), factors);
    keep(iteration_rate(grid, shape, "assembly"),
         (many->seconds - factors * many->size.factor_work) / many->size.particles);
  }

  /// The search is in another thread.
  void measure_modes() {
    constexpr int cells = 24;
    Scene scene = block(Dimension::plane_strain, cells, 2, *find_material_kind("neo_hookean"));
    scene.numerics.scheme = "TLMPM";
    scene.analysis.kind = Modal{};
    scene.bodies[0].initial_velocity = {};
    scene.outputs.samples = 5;
    const Model model = validate(scene);
    Simulation simulation(model, 1);
    const double begin = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
    while (simulation.sample() < model.outputs.samples) simulation.step();
    const double seconds = clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - begin;
    keep(modes_rate(), seconds / iteration_seconds(model, step_size(model, plan(model)), rates_).value());
  }

  void measure_formulas() {
    constexpr const char* formula = "1e-9 * sin(pi * x / 16) * cos(pi * y / 16) * exp(-t) / (1 + x * y)";
    Scene scene = block(Dimension::plane_strain, small(Dimension::plane_strain), 2);
    const auto plain = time_steps(scene);
    scene.loads = {{"field", BodyForce{{}, {}, {formula}}}};
    const auto loaded = time_steps(scene);
    if (plain && loaded) keep(formula_rate(), (loaded->seconds - plain->seconds) / loaded->size.formulas);
  }

  /// Of particles that no cache holds.
  void measure_memory() {
    constexpr int many = 160, few = 16;
    const auto large = time_steps(block(Dimension::plane_strain, many, 2));
    const auto small_one = time_steps(block(Dimension::plane_strain, few, 2));
    if (!large || !small_one) return;
    const double ratio = large->size.particles / small_one->size.particles;
    keep(memory_rate(), (large->seconds - ratio * small_one->seconds) / large->size.uncached_bytes);
  }

  /// On a block so small that threads have nothing to do but to wait for each other.
  void measure_waiting() {
    const auto alone = time_steps(block(Dimension::plane_strain, 1, 1), 1);
    const auto together = time_steps(block(Dimension::plane_strain, 1, 1), 2);
    if (alone && together) keep(waiting_rate(), together->seconds - alone->seconds);
  }

  const double slice_;
  Rates rates_;
};

}  // namespace

Rates measure_rates(double seconds) { return Measuring(seconds).rates(); }

}  // namespace trajan
