#include "solver/model/model.h"

#include <algorithm>

namespace trajan {

bool has_contact(const Model& model) {
  return model.contacts.fields > 1 ||
         std::ranges::any_of(model.conditions, [](const BoundaryCondition& condition) {
           return std::holds_alternative<RigidObstacle>(condition.kind);
         });
}

std::vector<std::string> history_columns(const Model& model) {
  std::vector<std::string> columns;
  for (const Probe& probe : model.outputs.probes) {
    for (const RecordedField& field : probe.fields) {
      const std::string name = probe.name + "." + field.name;
      if (field.components.empty()) columns.push_back(name);
      for (const std::string_view component : field.components)
        columns.push_back(std::string(name).append(".").append(component));
    }
  }
  for (const char* energy : {"kinetic", "strain", "work", "dissipated", "total", "balance_error"})
    columns.push_back(std::string("energies.") + energy);
  if (has_contact(model)) columns.emplace_back("energies.contact");
  for (const std::string_view axis : vector_components(model.dimension))
    columns.push_back("momentum." + std::string(axis));
  for (std::size_t condition : model.outputs.reactions)
    for (const std::string_view axis : vector_components(model.dimension))
      columns.push_back("reactions." + model.conditions[condition].name + "." + std::string(axis));
  for (std::size_t body : model.outputs.contact_forces)
    for (const std::string_view axis : vector_components(model.dimension))
      columns.push_back("reactions." + model.bodies[body].name + "." + std::string(axis));
  if (std::holds_alternative<Modal>(model.analysis)) {
    columns.insert(columns.end(), {"modes.frequency", "modes.residual"});
    for (const std::string_view axis : vector_components(model.dimension))
      columns.push_back("modes.participation." + std::string(axis));
  }
  if (std::holds_alternative<Buckling>(model.analysis))
    columns.insert(columns.end(), {"modes.load_factor", "modes.residual"});
  if (std::holds_alternative<Relaxation>(model.analysis))
    columns.insert(columns.end(), {"relaxation.residual", "relaxation.steps"});
  const auto* statics = std::get_if<QuasiStatic>(&model.analysis);
  if (statics && statics->arc_length) columns.push_back("load_factor");
  return columns;
}

}  // namespace trajan
