#include <cmath>

#include "tests/stability/all_cases.h"

/// Free vibration over very many steps: nothing may grow, and what keeps energy goes on keeping it.
namespace trajan::stability {

namespace {

struct Keeping {
  const char *scheme, *shape_functions, *transfer;
  bool keeps;
};
/// FLIP keeps energy but for leapfrog's swaps, save under USL, which takes some (Bardenhagen 2002); the others
/// smooth velocities in every step, and may take all of it. MUSL and USF take gradients at one end of each step,
/// where moving particles see others than in its middle: of smooth functions that makes energy, and they warn. So
/// does USAVG, of which rounding grows until it takes 2.5 % in 10^6 steps.
constexpr Keeping kinds[] = {{"USF", "linear", "FLIP", true},
                             {"MUSL", "linear", "FLIP", true},
                             {"TLMPM", "linear", "FLIP", true},
                             {"MUSL", "quadratic_bspline", "FLIP", true},
                             {"USF", "quadratic_bspline", "FLIP", true},
                             {"USAVG", "linear", "FLIP", true},
                             {"USAVG", "quadratic_bspline", "FLIP", true},
                             {"TLMPM", "quadratic_bspline", "FLIP", true},
                             {"USL", "linear", "FLIP", false},
                             {"MUSL", "quadratic_bspline", "APIC", false},
                             {"TLMPM", "linear", "APIC", false},
                             {"MUSL", "linear", "XPIC", false}};

double drift(const Attempt& run) {
  const std::vector<double> total = run.history("energies.total");
  return total.back() / total.front() - 1;
}

}  // namespace

std::vector<Extreme> long_runs(Size size) {
  const double steps = size == Size::quick ? 2e4 : 1e6;
  std::vector<Extreme> extremes;
  for (const Keeping& kind : kinds) {
    Extreme extreme;
    extreme.name = std::string(kind.scheme) + " " + kind.shape_functions + " " + kind.transfer + ", " +
                   std::to_string(static_cast<int>(steps)) + " steps";
    extreme.claim = kind.keeps ? "drift of the energy" : "growth of the energy";
    const bool errs =
        kind.shape_functions == std::string("quadratic_bspline") && kind.scheme != std::string("TLMPM");
    // Beyond that what keeps energy warns.
    extreme.bound = 0.02;
    extreme.may_stop = errs || !kind.keeps;
    Scene& scene = extreme.scene;
    scene = test::bar(kind.scheme, "linear_elastic", 0.5, 0.01);
    scene.domain = {Dimension::bar, {0}, {12}, 0.5, {}};
    scene.bodies[0].geometry = Box{{0}, {10}};
    scene.boundaries[0].nodes = Box{{0}, {0}};
    scene.outputs.probes.clear();
    scene.numerics.shape_functions = kind.shape_functions;
    scene.numerics.transfer = kind.transfer;
    // Half of what a wave takes through a cell.
    scene.analysis.end_time = steps * 0.5 * 0.5 / 10;
    scene.outputs.samples = 200;
    extreme.figure = kind.keeps ? drift : energy_gain;
    extremes.push_back(extreme);
  }
  return extremes;
}

}  // namespace trajan::stability
