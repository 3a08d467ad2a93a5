#include "tests/verification/bands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "solver/model/validate.h"
#include "tests/verification/convergence.h"
#include "tests/verification/gallery.h"

namespace trajan::verification {

namespace {

/// Tolerances below this are of identities.
constexpr double least_tolerance = 1e-8;

/// Runs of a scene with other cells, each once.
class Runs {
 public:
  explicit Runs(Scene scene) : scene_(std::move(scene)) {}

  const Scene& scene() const { return scene_; }

  /// Null if the cells do not fit the scene or the run diverges: a study would say so.
  const Outcome* with(double factor) {
    const auto found = outcomes_.find(factor);
    if (found != outcomes_.end()) return found->second ? &*found->second : nullptr;
    std::optional<Outcome>& outcome = outcomes_[factor];
    try {
      outcome = run_scene(with_cells(scene_, factor * scene_.domain.cell_size));
    } catch (const std::runtime_error&) {
      return nullptr;
    }
    return &*outcome;
  }

 private:
  const Scene scene_;
  std::map<double, std::optional<Outcome>> outcomes_;
};

bool is_answer(const Scene& scene, const MeasureValue& measure) {
  const auto definition = std::ranges::find(scene.measures, measure.name, &MeasureDefinition::name);
  return !accuracy::is_check(definition->quantity, measure.exact,
                             std::holds_alternative<Deviation>(definition->kind));
}

void add_ladder(Runs& runs, const std::vector<double>& factors, std::vector<BandCase>& cases) {
  std::vector<const Outcome*> outcomes;
  for (const double factor : factors) outcomes.push_back(runs.with(factor));
  if (std::ranges::find(outcomes, nullptr) != outcomes.end()) return;
  for (const MeasureValue& measure : outcomes.back()->measures) {
    if (!measure.exact || measure.tolerance.value_or(1) < least_tolerance) continue;
    BandCase& band_case = cases.emplace_back();
    band_case.scene = runs.scene().name;
    band_case.measure = measure.name;
    band_case.exact = *measure.exact;
    band_case.is_answer = is_answer(runs.scene(), measure);
    for (std::size_t level = 0; level < factors.size(); ++level)
      band_case.levels.push_back(
          {factors[level] * runs.scene().domain.cell_size, outcomes[level]->measure(measure.name).value});
    band_case.estimate = accuracy::estimate(band_case.levels);
  }
}

}  // namespace

double BandCase::error() const { return std::abs(levels.back().value - exact); }

std::vector<BandCase> band_cases(const std::string& name, bool finer) {
  Runs runs(gallery_scene(name));
  std::vector<BandCase> cases;
  add_ladder(runs, {4, 2, 1}, cases);
  add_ladder(runs, {2, 4.0 / 3, 1}, cases);
  const auto& constants = runs.scene().constants;
  if (finer && std::ranges::find(constants, "cell", &Constant::name) == constants.end())
    add_ladder(runs, {2, 1, 0.5}, cases);
  return cases;
}

}  // namespace trajan::verification
