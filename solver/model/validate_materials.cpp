#include <algorithm>
#include <cmath>

#include "solver/model/names.h"
#include "solver/model/validator.h"
#include "solver/schemes/scheme.h"

namespace trajan {

namespace {

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const MaterialKind& kind : material_kinds()) names.emplace_back(kind.name);
  return names;
}

std::string range_text(const Parameter& parameter) {
  std::string text;
  // A bound against overflow alone is none that people need to know.
  if (parameter.lowest > -1e300)
    text += (parameter.lowest_allowed ? "at least " : "greater than ") + number_text(parameter.lowest);
  if (parameter.highest < 1e300) {
    text += (text.empty() ? "" : " and ") + std::string(parameter.highest_allowed ? "at most " : "less than ") +
            number_text(parameter.highest);
  }
  return text.empty() ? "finite" : text;
}

}  // namespace

void Validator::check_materials() {
  if (scene_.materials.empty()) {
    violations_.add("materials", "", "there is no material", "define at least one");
  }
  if (!check_list("materials", scene_.materials)) return;
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    const MaterialDefinition& definition = scene_.materials[i];
    const std::string path = indexed("materials", i);
    Material& material = model_.materials.emplace_back();
    material.name = definition.name;
    material.density = definition.density;
    violations_.positive(path + ".density", definition.density);
    check_law(path, definition, material);
  }
}

void Validator::check_law(const std::string& path, const MaterialDefinition& definition, Material& material) {
  if (definition.law.empty()) {
    violations_.add(path, "", "no constitutive law is given", "give one of: " + list_of(law_names()));
    return;
  }
  material.kind = find_material_kind(definition.law);
  if (material.kind == nullptr) return unknown_name(path, definition.law, "constitutive law", law_names());
  const std::string law_path = path + "." + definition.law;
  std::vector<std::string> known;
  bool complete = definition.density > 0;
  for (const Parameter& parameter : material.kind->parameters) {
    known.emplace_back(parameter.name);
    const auto given = definition.parameters.find(known.back());
    if (given == definition.parameters.end() && parameter.optional()) {
      material.parameters.push_back(parameter.otherwise);
      continue;
    }
    if (given == definition.parameters.end()) {
      complete =
          violations_.add(law_path + "." + known.back(), "", "not given (" + std::string(parameter.meaning) + ")",
                          "give a number " + range_text(parameter));
      continue;
    }
    material.parameters.push_back(given->second);
    complete = check_parameter(law_path + "." + known.back(), parameter, given->second) && complete;
  }
  for (const auto& [name, value] : definition.parameters) {
    if (std::ranges::find(known, name) == known.end()) {
      unknown_name(law_path + "." + shortened(name), name, "parameter", known);
      complete = false;
    }
  }
  check_use(law_path, *material.kind);
  if (!complete || model_.dimension == Dimension::unspecified) return;
  const Objection wrong = material.kind->check(material.parameters, model_.dimension);
  if (!wrong.problem.empty()) {
    violations_.add(law_path, "", wrong.problem, wrong.remedy);
    return;
  }
  const double speed = material.kind->wave_speed(material.parameters, material.density, model_.dimension);
  if (!(std::isfinite(speed) && speed > 0)) {
    violations_.add(path, "wave speed " + number_text(speed), "its numbers give no finite wave speed",
                    "give stiffness and density of less extreme size");
  }
}

void Validator::check_use(const std::string& path, const MaterialKind& kind) {
  const std::string& scheme = scene_.numerics.scheme;
  if (model_.dimension == Dimension::unspecified || std::ranges::count(scheme_names(), scheme) == 0) return;
  const std::string_view objection = kind.objection(model_.dimension, is_total_lagrangian(scheme));
  if (objection.empty()) return;
  violations_.add(path, "", std::string(kind.name) + " cannot be used here: " + std::string(objection),
                  "take another law, domain.dimension or numerics.scheme");
}

bool Validator::check_parameter(const std::string& path, const Parameter& parameter, double value) {
  if (parameter.allows(value)) return true;
  return violations_.add(path, number_text(value), "out of range for " + std::string(parameter.meaning),
                         "give a number " + range_text(parameter));
}

}  // namespace trajan
