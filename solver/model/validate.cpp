#include "solver/model/validate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/model/names.h"
#include "solver/model/validator.h"

namespace trajan {

InvalidScene::InvalidScene(std::vector<Violation> violations)
    : std::runtime_error("invalid scene: " + violations.at(0).path + ": " + violations.at(0).problem),
      violations_(std::move(violations)) {}

Model validate(const Scene& scene) { return Validator(scene).run(); }

Model Validator::run() {
  check_head();
  check_constants();
  check_domain();
  check_materials();
  check_bodies();
  // Formulas of time are checked up to its end.
  check_analysis();
  check_boundaries();
  check_contacts();
  check_loads();
  check_numerics();
  check_outputs();
  check_measures();
  if (violations_.empty()) check_combinations();
  if (violations_.empty()) check_time_step();
  if (!violations_.empty()) throw InvalidScene(violations_.take());
  return std::move(model_);
}

void Validator::check_head() {
  if (!is_identifier(scene_.name)) {
    violations_.add("name", scene_.name,
                    scene_.name.empty() ? "a scene needs a name" : quoted(scene_.name) + " is not a valid name",
                    "use 1 to 64 letters, digits, _ or -");
  }
  model_.name = scene_.name;
  model_.description = scene_.description;
  model_.units = scene_.units;
}

void Validator::check_constants() {
  if (scene_.constants.size() > most_entries) {
    violations_.add("constants", std::to_string(scene_.constants.size()) + " entries", "the list is too long",
                    "give at most " + std::to_string(most_entries));
    return;
  }
  for (std::size_t i = 0; i < scene_.constants.size(); ++i) {
    const auto& [name, text] = scene_.constants[i];
    const std::string path = indexed("constants", i);
    const bool letter_first = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
    if (!letter_first || !is_identifier(name) || name.find('-') != std::string::npos) {
      violations_.add(path + ".name", name, quoted(name) + " is not a name that formulas can use",
                      "use a letter followed by letters, digits and _, at most 64");
    } else if (is_reserved_in_expressions(name)) {
      violations_.add(path + ".name", name, quoted(name) + " means something else in formulas",
                      "choose another name");
    } else if (constants_.contains(name)) {
      violations_.add(path + ".name", name, quoted(name) + " is the name of an earlier constant",
                      "choose another name");
    }
    const auto value = formula(path + ".value", text, "");
    // A constant that is wrong still has a name: what uses it is not wrong as well.
    constants_.emplace(name, value ? (*value)({}, 0) : 1.0);
  }
}

void Checks::check_names(const std::string& path, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string place = indexed(path, i) + ".name";
    if (!is_identifier(names[i])) {
      violations_.add(place, names[i],
                      names[i].empty() ? "a name is needed" : quoted(names[i]) + " is not a valid name",
                      "use 1 to 64 letters, digits, _ or -");
    } else if (!seen.insert(names[i]).second) {
      violations_.add(place, names[i], quoted(names[i]) + " is the name of an earlier entry",
                      "choose another name");
    }
  }
}

void Checks::unknown_name(const std::string& path, const std::string& name, const std::string& what,
                          const std::vector<std::string>& known) {
  const std::string problem =
      name.empty() ? "no " + what + " is named" : "there is no " + what + " " + quoted(name);
  if (known.empty()) {
    violations_.add(path, name, problem, "define a " + what);
    return;
  }
  const std::vector<std::string> sorted = violations_.worth_a_hint() ? nearest_first(name, known) : known;
  const std::string hint = did_you_mean(name, std::span(sorted).first(1));
  violations_.add(path, name, problem,
                  hint.empty() ? "the " + plural(what) + " are: " + list_of(sorted)
                               : hint + " (" + plural(what) + ": " + list_of(sorted) + ")");
}

}  // namespace trajan
