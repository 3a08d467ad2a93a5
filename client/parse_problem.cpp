#include "client/parse_problem.h"

#include <fmt/format.h>

#include <cctype>
#include <regex>

#include "proto/suggestion.h"
#include "trajan/v1/scene.pb.h"

namespace trajan::client {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

std::vector<std::string> field_names(const Descriptor& message) {
  std::vector<std::string> names;
  for (int i = 0; i < message.field_count(); ++i) names.push_back(message.field(i)->name());
  return names;
}

/// The values of an enum that people may write; the one numbered 0 that stands for "not given" is not among them.
std::vector<std::string> enum_names(const google::protobuf::EnumDescriptor& type) {
  std::vector<std::string> names;
  for (int i = 0; i < type.value_count(); ++i) {
    const std::string& name = type.value(i)->name();
    if (!name.ends_with("_UNSPECIFIED")) names.push_back(name);
  }
  return names;
}

std::string expected_form(const FieldDescriptor* field) {
  if (field == nullptr) return {};
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_STRING:
      return fmt::format("write text in quotes, {}: \"...\"", field->name());
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return fmt::format("write a number, for example {}: 1.5", field->name());
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_INT64:
      return fmt::format("write a whole number, for example {}: 2", field->name());
    case FieldDescriptor::CPPTYPE_BOOL:
      return fmt::format("write {0}: true or {0}: false", field->name());
    case FieldDescriptor::CPPTYPE_ENUM:
      return fmt::format("write {}: followed by one of {}", field->name(),
                         fmt::join(enum_names(*field->enum_type()), ", "));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return fmt::format("write {} {{ ... }} with {}", field->name(),
                         fmt::join(field_names(*field->message_type()), ", "));
    default:
      return {};
  }
}

std::string described_place(const std::vector<std::string>& names) {
  if (names.size() < 2) return "a scene";
  return fmt::format("\"{}\"", names[names.size() - 2]);
}

ParseProblem unknown_field(const std::string& name, const std::vector<std::string>& names) {
  const Descriptor* message = enclosing_message(names);
  const std::vector<std::string> known = message == nullptr ? std::vector<std::string>() : field_names(*message);
  return {fmt::format("there is no field \"{}\" in {}", name, described_place(names)),
          suggest(name, known, "its fields are"), nearest_word(name, known)};
}

ParseProblem unknown_value(const std::string& value, const FieldDescriptor* field, const std::string& field_name) {
  const bool known = field != nullptr && field->enum_type() != nullptr;
  const std::vector<std::string> values = known ? enum_names(*field->enum_type()) : std::vector<std::string>();
  return {
      fmt::format("\"{}\" is not a value of {}", value, field_name), suggest(value, values, "write one of"), {}};
}

}  // namespace

const Descriptor* enclosing_message(const std::vector<std::string>& names) {
  const Descriptor* message = v1::Scene::descriptor();
  for (std::size_t i = 0; i + 1 < names.size() && message != nullptr; ++i) {
    const FieldDescriptor* field = message->FindFieldByName(names[i]);
    message = field == nullptr ? nullptr : field->message_type();
  }
  return message;
}

ParseProblem explain_parse_problem(const std::string& whole_message, const std::vector<std::string>& names) {
  const std::string parser_says = whole_message.substr(0, longest_parser_message);
  static const std::regex no_field(R"re(has no field named "([^"]*)")re");
  static const std::regex no_value(R"re(Unknown enumeration value of "(.*)" for field "([^"]*)")re");
  static const std::regex second_choice(R"re(Field "([^"]*)" is specified along with field "([^"]*)")re");
  static const std::regex twice(R"re(Non-repeated field "([^"]*)")re");
  static const std::regex bad_value(R"re(Expected (.*), (?:got|found)(?: |: )"?(.*?)"?\.?$)re");

  const Descriptor* message = enclosing_message(names);
  const FieldDescriptor* field =
      message == nullptr || names.empty() ? nullptr : message->FindFieldByName(names.back());
  std::smatch match;
  if (std::regex_search(parser_says, match, no_field)) return unknown_field(match[1], names);
  if (std::regex_search(parser_says, match, no_value)) return unknown_value(match[1], field, match[2]);
  if (std::regex_search(parser_says, match, second_choice)) {
    return {fmt::format("\"{}\" cannot be given together with \"{}\"", match[1].str(), match[2].str()),
            "keep one of them",
            {}};
  }
  if (std::regex_search(parser_says, match, twice)) {
    return {fmt::format("\"{}\" is given twice", match[1].str()), "keep one of them", {}};
  }
  if (std::regex_search(parser_says, match, bad_value)) {
    const std::string found = match[2].str();
    const std::string expected = match[1] == "double" ? "number" : match[1].str();
    return {fmt::format("expected {}, found {}", expected, found.empty() ? "the end" : found),
            expected_form(field),
            {}};
  }
  std::string said = parser_says;
  if (said.ends_with('.')) said.pop_back();
  if (!said.empty()) said[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(said[0])));
  return {said, expected_form(field), {}};
}

}  // namespace trajan::client
