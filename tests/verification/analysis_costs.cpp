// What the same answer costs by different analyses, as a Markdown table.
//   analysis_costs
#include <cstdio>
#include <exception>
#include <string>

#include "tests/verification/convergence.h"
#include "tests/verification/gallery.h"

namespace trajan::verification {
namespace {

void print(const std::string& answer, const std::string& analysis, const Outcome& outcome,
           const std::string& measure) {
  const MeasureValue& value = outcome.measure(measure);
  std::printf("| %s | %s | %.6g | %+.3f %% | %lld | %.2f s |\n", answer.c_str(), analysis.c_str(), value.value,
              100 * value.error.value_or(0), static_cast<long long>(outcome.steps), outcome.seconds);
  std::fflush(stdout);
}

/// The gallery's cantilever, its load applied at once.
Scene statics(AnalysisKind kind) {
  Scene scene = gallery_scene("cantilever");
  scene.analysis = {1, 0, kind};
  scene.loads.at(0).time = Ramp{0, 1, false};
  scene.outputs.samples = 1;
  scene.outputs.snapshots = 1;
  std::erase_if(scene.measures, [](const MeasureDefinition& m) { return m.name == "remaining_speed"; });
  return scene;
}

/// Modes with the lumped mass that histories have.
Scene modes(double cell_size) {
  Scene scene = with_cells(gallery_scene("beam_modes"), cell_size);
  scene.analysis.kind = Modal{MassMatrix::lumped};
  return scene;
}

void print_table() {
  std::puts("| answer | analysis | value | error | steps | one core |");
  std::puts("|---|---|--:|--:|--:|--:|");
  const std::string tip = "tip_deflection";
  print(tip, "explicit, ramp", run_scene(gallery_scene("cantilever")), tip);
  print(tip, "relaxation", run_scene(statics(Relaxation{})), tip);
  Scene faster = statics(Relaxation{});
  faster.numerics.time_step_fraction = 0.9;
  print(tip, "relaxation, time_step_fraction 0.9", run_scene(faster), tip);
  QuasiStatic steps;
  steps.load_steps = 1;
  print(tip, "quasi_static, one load step", run_scene(statics(steps)), tip);
  const std::string frequency = "first_frequency";
  print(frequency, "explicit, history", run_scene(gallery_scene("ss_beam")), frequency);
  print(frequency, "modal, the same cells and mass", run_scene(modes(0.125)), frequency);
  print(frequency, "modal, cells half as large", run_scene(modes(0.0625)), frequency);
}

}  // namespace
}  // namespace trajan::verification

int main() {
  try {
    trajan::verification::print_table();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "analysis_costs: %s\n", error.what());
    return 1;
  }
}
