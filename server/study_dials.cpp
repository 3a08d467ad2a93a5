#include "server/study_dials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "server/errors.h"
#include "server/study_table.h"

namespace trajan {

namespace {

/// The shortest text that reads back to the same number.
std::string exact_text(double value) {
  char text[32];
  for (int digits = 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

void require(bool holds, const std::string& problem) {
  if (!holds) throw ServiceError(grpc::StatusCode::INVALID_ARGUMENT, "LADDER", problem);
}

v1::Setting setting(const std::string& name, const std::vector<std::string>& changes) {
  v1::Setting result;
  result.set_name(name);
  for (const std::string& change : changes) result.add_changes(change);
  return result;
}

/// Whether a constant "cell" stands for the cell size, as in exact values that depend on it.
bool is_cell_size(const v1::Scene& scene, const v1::Constant& constant) {
  char* end = nullptr;
  const bool is_equal = std::strtod(constant.value().c_str(), &end) == scene.domain().cell_size() && *end == '\0';
  return constant.name() == "cell" && is_equal;
}

/// A way to the answer, apart from scheme and shape functions.
struct Way {
  std::string name;
  std::vector<std::string> changes;
  bool is_explicit = true;
};

/// Loads that end at rest have one load level that matters, the last.
Way statics(const std::string& name, const std::string& kind) {
  return {
      name, {"analysis.damping=0", "analysis." + kind + "={}", "outputs.samples=1", "outputs.snapshots=1"}, false};
}

/// All measures ask for values at the end, or as good as that.
bool asks_for_the_end(const v1::Scene& scene) {
  return std::ranges::all_of(scene.measures(), [&](const v1::Measure& measure) {
    return measure.has_final() || measure.from() > 0.5 * scene.analysis().end_time();
  });
}

std::vector<Way> ways_of(const v1::Scene& scene) {
  const v1::Analysis& analysis = scene.analysis();
  switch (analysis.kind_case()) {
    case v1::Analysis::kRelaxation:
      return {{"relaxation", {}}, {"implicit", {"analysis.quasi_static={}"}, false}};
    case v1::Analysis::kQuasiStatic:
      if (analysis.quasi_static().has_arc_length()) return {{"implicit", {}, false}};
      return {{"implicit", {}, false}, {"relaxation", {"analysis.relaxation={}"}}};
    case v1::Analysis::kImplicitDynamics:
      return {{"implicit", {}, false}, {"explicit", {"analysis.explicit_dynamics={}"}}};
    case v1::Analysis::kModal:
      return {{"consistent mass", {"analysis.modal.mass=CONSISTENT"}, false},
              {"lumped mass", {"analysis.modal.mass=LUMPED"}, false}};
    case v1::Analysis::kBuckling:
      return {{"buckling", {}, false}};
    default:
      break;
  }
  if (analysis.damping() > 0 && asks_for_the_end(scene))
    return {{"ramp", {}}, statics("relaxation", "relaxation"), statics("implicit", "quasi_static")};
  constexpr int default_samples = 200;
  const int samples = scene.outputs().has_samples() ? scene.outputs().samples() : default_samples;
  const std::string steps = std::to_string(samples);
  return {{"explicit", {}}, {"implicit", {"analysis.implicit_dynamics={time_steps: " + steps + "}"}, false}};
}

/// The way that tradeoffs of the gallery found to be the cheapest: statics by implicit load steps, modes by lumped
/// masses, motions as they are asked for.
const Way& best_of(const std::vector<Way>& ways) {
  const bool is_motion = std::ranges::find(ways, "explicit", &Way::name) != ways.end();
  const auto found = std::ranges::find_if(
      ways, [](const Way& way) { return way.name == "implicit" || way.name == "lumped mass"; });
  return is_motion || found == ways.end() ? ways[0] : *found;
}

/// Choices of scheme, shape functions and transfer that are worth a try.
const std::vector<Way>& choices() {
  static const std::vector<Way> all{
      {"TLMPM linear", {"numerics.scheme=TLMPM", "numerics.shape_functions=linear"}, false},
      {"TLMPM quadratic", {"numerics.scheme=TLMPM", "numerics.shape_functions=quadratic_bspline"}, false},
      {"TLMPM cubic", {"numerics.scheme=TLMPM", "numerics.shape_functions=cubic_bspline"}, false},
      {"MUSL linear", {"numerics.scheme=MUSL", "numerics.shape_functions=linear"}, false},
      {"MUSL CPDI", {"numerics.scheme=MUSL", "numerics.shape_functions=cpdi"}, false},
      {"MUSL quadratic", {"numerics.scheme=MUSL", "numerics.shape_functions=quadratic_bspline"}, false},
      {"USL linear", {"numerics.scheme=USL", "numerics.shape_functions=linear"}},
      {"USL quadratic", {"numerics.scheme=USL", "numerics.shape_functions=quadratic_bspline"}},
      {"MUSL quadratic APIC",
       {"numerics.scheme=MUSL", "numerics.shape_functions=quadratic_bspline", "numerics.transfer=APIC"}},
      {"TLMPM linear, long steps",
       {"numerics.scheme=TLMPM", "numerics.shape_functions=linear", "numerics.time_step_fraction=0.9"}},
  };
  return all;
}

/// Whether laws have no memory and keep the configuration that they start from: what total Lagrangian steps are
/// for.
bool is_elastic(const v1::Scene& scene) {
  return std::ranges::all_of(scene.materials(), [](const v1::Material& material) {
    return material.law_case() < v1::Material::kVonMises && !material.has_damage();
  });
}

/// A length of a few digits that differences of others have spoilt in the last ones.
double without_rounding(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", length);
  return std::strtod(text, nullptr);
}

/// The largest length of which a length, the edges of a region that is a box, and their distances from the
/// domain's corner are whole multiples; the length itself for other regions.
double common_divisor(double common, const v1::Scene& scene, const v1::Region& region) {
  if (!region.has_box()) return common;
  const v1::Vector &lower = region.box().lower(), &upper = region.box().upper(), &corner = scene.domain().lower();
  for (double length : {upper.x() - lower.x(), upper.y() - lower.y(), upper.z() - lower.z(),
                        lower.x() - corner.x(), lower.y() - corner.y(), lower.z() - corner.z()}) {
    // Euclid's algorithm, up to rounding.
    while (length > 1e-9 * scene.domain().cell_size())
      common = std::exchange(length, std::abs(std::remainder(common, length)));
  }
  return common;
}

}  // namespace

v1::Setting with_cell_size(const v1::Scene& scene, double cell_size) {
  const double before = scene.domain().cell_size();
  const double ratio = cell_size / before;
  std::vector<std::string> changes{"domain.cell_size=" + exact_text(cell_size)};
  for (int i = 0; i < scene.constants_size(); ++i) {
    if (is_cell_size(scene, scene.constants(i)))
      changes.push_back("constants[" + std::to_string(i) + "].value=" + exact_text(cell_size));
  }
  if (scene.numerics().has_time_step())
    changes.push_back("numerics.time_step=" + exact_text(scene.numerics().time_step() * ratio));
  if (scene.analysis().has_implicit_dynamics()) {
    constexpr int default_steps = 100;
    const v1::ImplicitDynamics& motion = scene.analysis().implicit_dynamics();
    const int steps = motion.has_time_steps() ? motion.time_steps() : default_steps;
    const auto scaled = static_cast<std::int64_t>(std::ceil(steps / ratio - 1e-9));
    changes.push_back("analysis.implicit_dynamics.time_steps=" + std::to_string(scaled));
  }
  return setting(exact_text(cell_size), changes);
}

double common_length(const v1::Scene& scene) {
  const double cell = scene.domain().cell_size();
  double common = 0;
  for (const v1::Body& body : scene.bodies()) common = common_divisor(common, scene, body.geometry());
  if (common > 0) common = std::max(common, cell);
  for (const v1::Probe& probe : scene.outputs().probes()) {
    const double with_probe = common_divisor(common, scene, probe.mean());
    if (with_probe > (1 - 1e-9) * cell) common = with_probe;
  }
  return without_rounding(common);
}

v1::Dial ladder_dial(const v1::Scene& scene, const v1::Ladder& ladder) {
  const int levels = ladder.has_levels() ? ladder.levels() : 3;
  const double ratio = ladder.has_ratio() ? ladder.ratio() : 2;
  const double finest = ladder.has_finest() ? ladder.finest() : scene.domain().cell_size();
  require(levels >= 3 && levels <= 6, "a ladder has 3 to 6 levels");
  require(ratio >= 1.1 && ratio <= 4, "the ratio of a ladder is 1.1 to 4");
  require(std::isfinite(finest) && finest > 0, "the finest cell size of a ladder must be positive");
  v1::Dial dial;
  dial.set_name(cell_size_dial);
  for (int level = levels - 1; level >= 0; --level)
    *dial.add_settings() = with_cell_size(scene, finest * std::pow(ratio, level));
  return dial;
}

google::protobuf::RepeatedPtrField<v1::Dial> default_dials(const v1::Scene& scene) {
  const bool depends = std::ranges::any_of(
      scene.constants(), [&](const v1::Constant& constant) { return is_cell_size(scene, constant); });
  v1::Ladder ladder;
  if (!depends) ladder.set_finest(scene.domain().cell_size() / 2);
  google::protobuf::RepeatedPtrField<v1::Dial> dials;
  v1::Dial& methods = *dials.Add();
  methods.set_name("method");
  for (const Way& way : ways_of(scene)) {
    for (const Way& choice : choices()) {
      if (choice.is_explicit && !way.is_explicit) continue;
      std::vector<std::string> changes = way.changes;
      changes.insert(changes.end(), choice.changes.begin(), choice.changes.end());
      *methods.add_settings() = setting(way.name + ", " + choice.name, changes);
    }
  }
  *dials.Add() = ladder_dial(scene, ladder);
  return dials;
}

std::vector<v1::Setting> target_methods(const v1::Scene& scene) {
  const std::vector<Way> ways = ways_of(scene);
  const Way& way = best_of(ways);
  const auto total = [&](const std::string& functions, const std::string& name) {
    std::vector<std::string> changes = way.changes;
    changes.insert(changes.end(), {"numerics.scheme=TLMPM", "numerics.shape_functions=" + functions});
    if (way.is_explicit) changes.emplace_back("numerics.time_step_fraction=0.9");
    return setting(way.name + ", TLMPM " + name, changes);
  };
  std::vector<v1::Setting> methods;
  if (is_elastic(scene)) {
    methods.push_back(total("linear", "linear"));
    methods.push_back(total("quadratic_bspline", "quadratic"));
  }
  methods.push_back(setting(way.name + ", as the scene says", way.changes));
  if (!way.changes.empty()) methods.push_back(setting("as the scene says", {}));
  return methods;
}

}  // namespace trajan
