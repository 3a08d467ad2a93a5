#include "solver/cost/rates.h"

namespace trajan {
namespace {

std::string_view name_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::bar:
      return "bar";
    case Dimension::plane_stress:
      return "plane_stress";
    case Dimension::plane_strain:
      return "plane_strain";
    case Dimension::axisymmetric:
      return "axisymmetric";
    case Dimension::solid:
      return "solid";
    case Dimension::unspecified:
      break;
  }
  return "unspecified";
}

/// Grids of both planes are the same; their laws differ.
std::string_view grid_of(Dimension dimension) {
  return name_of(dimension == Dimension::plane_stress ? Dimension::plane_strain : dimension);
}

std::string joined(std::initializer_list<std::string_view> words) {
  std::string text;
  for (std::string_view word : words) text.append(text.empty() ? "" : "/").append(word);
  return text;
}

}  // namespace

std::string step_rate(Dimension dimension, const Numerics& numerics, std::string_view of) {
  return joined({grid_of(dimension), numerics.shape_functions, numerics.scheme, of});
}

std::string transfer_rate(Dimension dimension, const Numerics& numerics) {
  std::string name = joined({grid_of(dimension), numerics.shape_functions, numerics.transfer});
  if (numerics.transfer_order) name += std::to_string(*numerics.transfer_order);
  return name;
}

std::string law_rate(Dimension dimension, bool total_lagrangian, std::string_view law) {
  return joined({name_of(dimension), total_lagrangian ? "total" : "updated", law});
}

std::string contact_rate(Dimension dimension, std::string_view shape_functions) {
  return joined({grid_of(dimension), shape_functions, "contact"});
}

std::string sample_rate(Dimension dimension, bool total_lagrangian, std::string_view law) {
  return joined({law_rate(dimension, total_lagrangian, law), "sample"});
}

std::string iteration_rate(Dimension dimension, std::string_view shape_functions, std::string_view of) {
  return joined({grid_of(dimension), shape_functions, of});
}

std::string tangent_rate(Dimension dimension, std::string_view law) {
  return joined({name_of(dimension), "tangent", law});
}

std::string modes_rate() { return "modes"; }

std::string formula_rate() { return "formula"; }

std::string memory_rate() { return "memory"; }

std::string waiting_rate() { return "waiting"; }

std::string recording_rate(std::string_view of) { return joined({"recording", of}); }

std::string processing_rate(std::string_view of) { return joined({"processing", of}); }

}  // namespace trajan
