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

/// What the scene gives for a law's parameters or for those of its damage, in the order of the table.
bool Validator::read_parameters(const std::string& path, std::span<const Parameter> table,
                                const std::map<std::string, double>& values, Material& material) {
  std::vector<std::string> known;
  bool complete = true;
  for (const Parameter& parameter : table) {
    const std::string place = path + "." + known.emplace_back(parameter.name);
    const auto given = values.find(known.back());
    if (given == values.end() && !parameter.optional()) {
      complete = violations_.add(place, "", "not given (" + std::string(parameter.meaning) + ")",
                                 "give a number " + range_text(parameter));
      continue;
    }
    material.parameters.push_back(given == values.end() ? parameter.otherwise : given->second);
    if (given != values.end()) complete = check_parameter(place, parameter, given->second) && complete;
  }
  for (const auto& [name, value] : values) {
    if (std::ranges::find(known, name) != known.end()) continue;
    unknown_name(path + "." + shortened(name), name, "parameter", known);
    complete = false;
  }
  return complete;
}

void Validator::check_law(const std::string& path, const MaterialDefinition& definition, Material& material) {
  if (definition.law.empty()) {
    violations_.add(path, "", "no constitutive law is given", "give one of: " + list_of(law_names()));
    return;
  }
  material.kind = find_material_kind(definition.law);
  if (material.kind == nullptr) return unknown_name(path, definition.law, "constitutive law", law_names());
  const std::string law_path = path + "." + definition.law;
  bool complete = read_parameters(law_path, material.kind->parameters, definition.parameters, material);
  if (definition.damage) complete = add_damage(path + ".damage", *definition.damage, material) && complete;
  check_use(law_path, *material.kind);
  if (complete && definition.density > 0 && model_.dimension != Dimension::unspecified)
    check_law_as_a_whole(path, law_path, material);
}

bool Validator::add_damage(const std::string& path, const std::map<std::string, double>& values,
                           Material& material) {
  const MaterialKind* damaged = find_material_kind(std::string(damage_prefix) + std::string(material.kind->name));
  if (damaged == nullptr) {
    return violations_.add(path, "", "law " + std::string(material.kind->name) + " is not elastic",
                           "leave out damage or give an elastic law");
  }
  const std::span<const Parameter> table = damaged->parameters.subspan(material.kind->parameters.size());
  material.kind = damaged;
  return read_parameters(path, table, values, material);
}

void Validator::check_law_as_a_whole(const std::string& path, const std::string& law_path,
                                     const Material& material) {
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
