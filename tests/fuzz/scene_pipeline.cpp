#include "tests/fuzz/scene_pipeline.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "client/scene_text.h"
#include "server/convert.h"
#include "tests/unit/server/scene_schema.h"

namespace trajan::testing {
namespace {

void require(bool promise, const std::string& what) {
  if (!promise) throw std::logic_error(what);
}

class SilentCollector : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int, int, const std::string&) override {}
};

/// What is sent goes over the wire, which lets only valid UTF-8 pass.
bool passes_the_wire(const google::protobuf::Message& message) {
  const std::unique_ptr<google::protobuf::Message> copy(message.New());
  return copy->ParseFromString(message.SerializeAsString());
}

/// The reading that says only yes or no, to judge the one that explains.
bool is_readable(const std::string& text) {
  SilentCollector errors;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&errors);
  v1::Scene scene, whole;
  whole.set_description(text);
  return parser.ParseFromString(text, &scene) && passes_the_wire(scene) && passes_the_wire(whole);
}

void check_diagnostic(const client::Diagnostic& diagnostic, std::size_t lines) {
  const auto line = static_cast<std::size_t>(diagnostic.position.line);
  require(line <= lines, "a diagnostic is beyond the end of the text: " + diagnostic.message);
  require(!diagnostic.message.empty(), "a diagnostic says nothing");
}

void check_reading(const client::SceneText& read, const std::string& text) {
  require(read.diagnostics().empty() == is_readable(text),
          "mistakes are reported where there are none, or hidden");
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  for (const client::Diagnostic& diagnostic : read.diagnostics()) check_diagnostic(diagnostic, lines);
}

void check_violation(const v1::Scene& scene, const Violation& violation) {
  const std::string about = violation.path + ": " + violation.problem;
  require(names_a_field(scene, violation.path), "a violation names no field: " + about);
  require(!violation.problem.empty(), "a violation has no problem: " + about);
  require(!violation.remedy.empty(), "a violation has no remedy: " + about);
  require(passes_the_wire(to_proto(violation)), "a violation cannot be sent: " + about);
}

/// What the client shows of violations is theirs and the text's own, and none is lost in a readable text.
void check_places(const client::SceneText& read, const std::vector<Violation>& violations) {
  v1::CheckSceneResponse response;
  for (const Violation& violation : violations) *response.add_violations() = to_proto(violation);
  const std::vector<client::Diagnostic> all = read.merge(response.violations());
  if (read.diagnostics().empty()) require(all.size() == violations.size(), "a violation is not shown");
  for (const client::Diagnostic& diagnostic : all)
    require(!diagnostic.message.empty(), "a diagnostic says nothing");
}

void check_plan(const Model& model, const ModelPlan& plan) {
  require(plan.particles > 0 && plan.particles == model.particle_count(),
          "the plan's particles are not the model's");
  require(plan.active_cells > 0, "the plan has no cells");
  require(std::isfinite(plan.time_step) && plan.time_step > 0, "the plan's time step is not a positive number");
  require(plan.steps > 0, "the plan has no steps");
  require(!plan.time_step_limit.empty(), "the plan does not say what limits the time step");
  require(plan.memory_bytes > 0, "the plan needs no memory");
  require(passes_the_wire(to_proto(plan)), "the plan cannot be sent");
}

}  // namespace

SceneFate run_pipeline(const std::string& text) {
  const client::SceneText read(text, client::SceneFormat::text);
  check_reading(read, text);
  const v1::Scene& message = read.scene();
  if (!read.has_structure() || !passes_the_wire(message)) return SceneFate::unreadable;
  try {
    const Model model = validate(to_scene(message));
    check_plan(model, plan(model));
    return read.diagnostics().empty() ? SceneFate::valid : SceneFate::unreadable;
  } catch (const InvalidScene& invalid) {
    require(!invalid.violations().empty(), "an invalid scene has no violation");
    for (const Violation& violation : invalid.violations()) check_violation(message, violation);
    check_places(read, invalid.violations());
    return read.diagnostics().empty() ? SceneFate::invalid : SceneFate::unreadable;
  }
}

}  // namespace trajan::testing
