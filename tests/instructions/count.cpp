// Takes steps, or iterations, of scenes. Callgrind counts the instructions of `counted_steps` and writes a count
// whenever that ends; what was counted is printed here, in the same order, a line each (count.py).
#include <cstdio>

#include "solver/analyses/background_recorder.h"
#include "solver/implicit/dynamic_steps.h"
#include "solver/implicit/quasi_static_steps.h"
#include "solver/implicit/steppers.h"
#include "solver/model/validate.h"
#include "solver/schemes/law_response.h"
#include "solver/simulation/simulation.h"
#include "tests/bench/cases.h"
#include "tests/levels/v3_kernels.h"

namespace trajan {

/// In the place of the solver's own choice.
const Kernels& kernels() { return x86_64_v3::compiled_kernels; }
/// Of analyses that solve equations two, with one law.
std::unique_ptr<Stepper> make_stepper(const Model& model, Executor& executor, const Checkpoint* resume) {
  if (const auto* analysis = std::get_if<QuasiStatic>(&model.analysis))
    return std::make_unique<QuasiStaticSteps>(model, *analysis, executor, resume);
  if (const auto* analysis = std::get_if<ImplicitDynamics>(&model.analysis))
    return std::make_unique<DynamicSteps>(model, *analysis, executor, resume);
  return nullptr;
}
const LawResponseKernels* response_of_neo_hookean(Dimension, bool total_lagrangian);
const LawResponseKernels* law_response(std::string_view, Dimension dimension, bool total_lagrangian) {
  return response_of_neo_hookean(dimension, total_lagrangian);
}

namespace {

/// Storing costs a lot here, and leaves nothing.
class Storage : public Recorder {
 public:
  void sample(std::int64_t, double, std::span<const double>) override {}
  void snapshot(std::int64_t, const Snapshot& snapshot) override {
    for (int i = 0; i < 1000; ++i)
      for (double x : snapshot.position) sum_ = sum_ + x;
  }
  void checkpoint(const Checkpoint&) override {}
  void warn(const Warning&) override {}
  std::int64_t durable_rows() const override { return 0; }

 private:
  volatile double sum_ = 0;
};

}  // namespace
}  // namespace trajan

/// The program's one function whose name callgrind is told.
extern "C" [[gnu::noinline]] void counted_steps(trajan::Simulation& simulation, const trajan::Model& model,
                                                trajan::Recorder& recorder, int steps) {
  const std::int64_t every = model.outputs.samples_per_snapshot;
  for (int i = 0; i < steps; ++i) {
    if (!simulation.step()) continue;
    recorder.sample(simulation.sample(), simulation.time(), simulation.columns());
    if (every > 0 && simulation.sample() % every == 0)
      recorder.snapshot(simulation.sample(), simulation.snapshot());
  }
}

namespace trajan {
namespace {

constexpr double particles = 2000;

/// Of steps after the first ones, which make what all later ones use again.
void count(const std::string& name, const Scene& scene, int steps = 10) {
  const Model model = validate(scene);
  Simulation simulation(model, 1);
  Storage storage;
  BackgroundRecorder recorder(storage);
  for (int i = 0; i < 4; ++i) simulation.step();
  counted_steps(simulation, model, recorder, steps);
  recorder.finish();
  std::printf("%s %lld %d %zu\n", name.c_str(), static_cast<long long>(model.particle_count()), steps,
              simulation.executor().memory());
}

const bench::Case& discs_by_musl() { return bench::cases().front(); }

void count_cases() {
  for (const bench::Case& one : bench::cases())
    if (x86_64_v3::can_step(one.choice)) count(one.choice.name, one.make(one.choice, particles));
}

/// Newton's iterations, of some load or time steps.
void count_implicit_cases() {
  for (const bench::Case& one : bench::cases())
    if (one.choice.kind == bench::Kind::implicit_static || one.choice.kind == bench::Kind::implicit_dynamic)
      count(one.choice.name, one.make(one.choice, particles), 5);
}

/// The colliding discs with one thing that does not concern them, or only one particle.
void count_what_is_not_used() {
  const Scene plain = discs_by_musl().make(discs_by_musl().choice, 4 * particles);
  count("unused/nothing", plain);
  Scene scene = plain;
  scene.materials.push_back({"unused", 1, "neo_hookean", {{"youngs_modulus", 1}, {"poissons_ratio", 0.3}}});
  count("unused/law", scene);
  scene = plain;
  scene.boundaries = {{"wall", Edge::left, Fixed{}}};
  count("unused/wall", scene);
  scene.boundaries = {{"plane", {}, RigidPlane{{0, -50}, {0, 1}, {}}}};
  count("unused/plane", scene);
  scene = plain;
  scene.loads = {{"poke", PointForce{"one", {0.2, 0.2}, {1e-3, 0}}, "t"}};
  count("unused/force", scene);
  scene = plain;
  scene.outputs.probes = {{"tip", Vector{0.2, 0.2}, {Field::displacement, Field::stress}, "one"}};
  count("unused/probe", scene);
}

/// In a domain three times and one a million times larger than the discs. Cells of a power of two, and the
/// domain's corners at corners of tiles: the discs are cut into tiles alike.
void count_domains() {
  Scene scene = discs_by_musl().make(discs_by_musl().choice, particles);
  scene.domain.cell_size = 1.0 / 32;
  scene.domain.lower = {-1, -1}, scene.domain.upper = {2, 2};
  count("domain/near", scene);
  scene.domain.lower = {-262144, -262144}, scene.domain.upper = {262144, 262144};
  count("domain/far", scene);
}

/// A sample each ten steps, which is a thousand in a run of 10^4.
void count_outputs() {
  Scene scene = discs_by_musl().make(discs_by_musl().choice, particles);
  scene.numerics.time_step = 1e-3;
  count("outputs/none", scene, 50);
  scene.outputs.samples = 100;
  scene.outputs.snapshots = 0;
  scene.analysis.end_time = 1;
  count("outputs/samples", scene, 50);
  scene.outputs.probes = {
      {"tip", Vector{0.2, 0.2}, {Field::displacement, Field::velocity, Field::stress}, "one"},
      {"other", Vector{0.8, 0.8}, {Field::displacement, Field::velocity, Field::stress}, "two"}};
  count("outputs/probes", scene, 50);
  scene.outputs.probes.clear();
  scene.outputs.snapshots = 100;
  count("outputs/snapshots", scene, 50);
}

}  // namespace
}  // namespace trajan

int main() {
  trajan::count_cases();
  trajan::count_implicit_cases();
  trajan::count_what_is_not_used();
  trajan::count_domains();
  trajan::count_outputs();
}
