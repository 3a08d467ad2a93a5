#include "tests/unit/server/scene_schema.h"

#include <regex>
#include <vector>

namespace trajan::testing {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

void add_schema(const Descriptor& type, std::set<std::string>& names) {
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (!names.insert(field.full_name()).second) continue;
    if (field.message_type()) add_schema(*field.message_type(), names);
    if (field.enum_type()) {
      for (int v = 0; v < field.enum_type()->value_count(); ++v)
        names.insert(field.enum_type()->value(v)->full_name());
    }
  }
}

void add_use(const Message& message, std::set<std::string>& names);

void add_enum_values(const Message& message, const FieldDescriptor& field, std::set<std::string>& names) {
  const auto& reflection = *message.GetReflection();
  if (!field.is_repeated()) names.insert(reflection.GetEnum(message, &field)->full_name());
  for (int i = 0; field.is_repeated() && i < reflection.FieldSize(message, &field); ++i) {
    names.insert(reflection.GetRepeatedEnum(message, &field, i)->full_name());
  }
}

void add_messages(const Message& message, const FieldDescriptor& field, std::set<std::string>& names) {
  const auto& reflection = *message.GetReflection();
  if (!field.is_repeated() && reflection.HasField(message, &field)) {
    add_use(reflection.GetMessage(message, &field), names);
  }
  for (int i = 0; field.is_repeated() && i < reflection.FieldSize(message, &field); ++i) {
    add_use(reflection.GetRepeatedMessage(message, &field, i), names);
  }
}

void add_use(const Message& message, std::set<std::string>& names) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) names.insert(field->full_name());
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    if (field.enum_type()) add_enum_values(message, field, names);
    if (field.message_type()) add_messages(message, field, names);
  }
}

const Message& descend(const Message& message, const FieldDescriptor& field, int index) {
  const auto& reflection = *message.GetReflection();
  return field.is_repeated() ? reflection.GetRepeatedMessage(message, &field, index)
                             : reflection.GetMessage(message, &field);
}

}  // namespace

std::set<std::string> schema_of(const Descriptor& root) {
  std::set<std::string> names;
  add_schema(root, names);
  return names;
}

std::set<std::string> used_by(const Message& message) {
  std::set<std::string> names;
  add_use(message, names);
  return names;
}

bool names_a_field(const Message& message, const std::string& path) {
  static const std::regex segment(R"(([a-z][a-z0-9_]*)(?:\[([0-9]{1,6})\])?(?:\.(.+))?)");
  std::smatch match;
  if (!std::regex_match(path, match, segment)) return false;
  const bool indexed = match[2].matched;
  const bool last = !match[3].matched;
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(match[1]);
  if (!field) return last && !indexed && message.GetDescriptor()->FindOneofByName(match[1]);
  if (indexed && !field->is_repeated()) return false;
  const int index = indexed ? std::stoi(match[2]) : 0;
  if (indexed && index >= message.GetReflection()->FieldSize(message, field)) return false;
  if (last) return true;
  if (!field->message_type() || (field->is_repeated() && !indexed)) return false;
  return names_a_field(descend(message, *field, index), match[3]);
}

}  // namespace trajan::testing
