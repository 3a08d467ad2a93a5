#include "solver/model/model.h"

#include <array>

namespace trajan {

namespace {

constexpr std::array<std::string_view, 8> global_columns = {
    "energies.kinetic", "energies.strain",        "energies.work", "energies.dissipated",
    "energies.total",   "energies.balance_error", "momentum.x",    "momentum.y"};

}  // namespace

std::vector<std::string> history_columns(const Model& model) {
  std::vector<std::string> columns;
  for (const Probe& probe : model.outputs.probes) {
    for (const Field field : probe.fields) {
      for (const std::string_view component : field_components(field)) {
        columns.push_back(probe.name + "." + std::string(field_name(field)) + "." + std::string(component));
      }
    }
  }
  columns.insert(columns.end(), global_columns.begin(), global_columns.end());
  return columns;
}

std::vector<std::string_view> field_components(Field field) {
  switch (field) {
    case Field::position:
    case Field::displacement:
    case Field::velocity:
      return {"x", "y"};
    case Field::stress:
      return {"xx", "yy", "xy", "zz"};
    case Field::unspecified:
      break;
  }
  return {};
}

std::string_view field_name(Field field) {
  switch (field) {
    case Field::position:
      return "position";
    case Field::displacement:
      return "displacement";
    case Field::velocity:
      return "velocity";
    case Field::stress:
      return "stress";
    case Field::unspecified:
      break;
  }
  return "unspecified";
}

}  // namespace trajan
