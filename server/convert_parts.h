#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "solver/scene/scene.h"
#include "trajan/v1/scene.pb.h"

/// The parts of `to_scene`: each subject of the schema has its own source file, convert_<subject>.cpp.
namespace trajan {

Vector to_vector(const v1::Vector& message);
VectorExpression to_vector_expression(const v1::VectorExpression& message);
SymmetricTensorExpression to_symmetric_tensor_expression(const v1::SymmetricTensorExpression& message);
TensorExpression to_tensor_expression(const v1::TensorExpression& message);
Region to_region(const v1::Region& message);
Edge to_edge(int value);
Surface to_surface(const v1::Surface& message);
Domain to_domain(const v1::Domain& message);
MaterialDefinition to_material(const v1::Material& message);
BoundaryDefinition to_boundary(const v1::Boundary& message);
LoadDefinition to_load(const v1::Load& message);
Analysis to_analysis(const v1::Analysis& message);
Outputs to_outputs(const v1::Outputs& message);
MeasureDefinition to_measure(const v1::Measure& message);

template <typename Messages, typename Convert>
auto convert_all(const Messages& messages, Convert convert) {
  std::vector<decltype(convert(messages[0]))> values;
  values.reserve(static_cast<std::size_t>(messages.size()));
  std::transform(messages.begin(), messages.end(), std::back_inserter(values), convert);
  return values;
}

}  // namespace trajan
