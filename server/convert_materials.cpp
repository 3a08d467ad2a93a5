#include <google/protobuf/descriptor.h>

#include "server/convert_parts.h"

namespace trajan {
namespace {

using google::protobuf::FieldDescriptor;

/// Fields of laws are numbers; a law with another kind of field has no place in a parameter table.
std::map<std::string, double> parameters_of(const google::protobuf::Message& law) {
  const auto& reflection = *law.GetReflection();
  const auto& descriptor = *law.GetDescriptor();
  std::map<std::string, double> parameters;
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const FieldDescriptor* field = descriptor.field(i);
    if (field->is_repeated() || field->cpp_type() != FieldDescriptor::CPPTYPE_DOUBLE) continue;
    if (field->has_presence() && !reflection.HasField(law, field)) continue;
    parameters.emplace(field->name(), reflection.GetDouble(law, field));
  }
  return parameters;
}

}  // namespace

MaterialDefinition to_material(const v1::Material& message) {
  MaterialDefinition material;
  material.name = message.name();
  material.density = message.density();
  const auto& reflection = *message.GetReflection();
  const auto* laws = v1::Material::descriptor()->FindOneofByName("law");
  if (const FieldDescriptor* law = reflection.GetOneofFieldDescriptor(message, laws)) {
    material.law = law->name();
    material.parameters = parameters_of(reflection.GetMessage(message, law));
  }
  if (message.has_damage()) material.damage = parameters_of(message.damage());
  return material;
}

}  // namespace trajan
