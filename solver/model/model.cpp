#include "solver/model/model.h"

namespace trajan {

std::vector<std::string> history_columns(const Model& model) {
  std::vector<std::string> columns;
  for (const Probe& probe : model.outputs.probes) {
    for (const Field field : probe.fields) {
      for (const std::string_view component : field_components(field, model.dimension)) {
        columns.push_back(probe.name + "." + std::string(field_name(field)) + "." + std::string(component));
      }
    }
  }
  for (const char* energy : {"kinetic", "strain", "work", "dissipated", "total", "balance_error"})
    columns.push_back(std::string("energies.") + energy);
  for (const std::string_view axis : vector_components(model.dimension))
    columns.push_back("momentum." + std::string(axis));
  return columns;
}

}  // namespace trajan
