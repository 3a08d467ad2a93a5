#include "tests/fuzz/scene_mutator.h"

#include <google/protobuf/descriptor.h>

#include <limits>

namespace trajan::testing {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double numbers[] = {0.0,     -0.0,     1.0,      -1.0,      0.5,
                              1e-9,    1e9,      1e-300,   5e-324,    1e300,
                              1.7e308, -1.7e308, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
constexpr double factors[] = {-1.0, 0.5, 2.0, 3.7, 1e-3, 1e3, 1e-6, 1e6};
constexpr std::int32_t integers[] = {0,
                                     1,
                                     -1,
                                     2,
                                     16,
                                     17,
                                     1000,
                                     10'000'000,
                                     10'000'001,
                                     std::numeric_limits<std::int32_t>::max(),
                                     std::numeric_limits<std::int32_t>::min()};
constexpr const char* words[] = {"",
                                 "x",
                                 "y",
                                 "t",
                                 "z",
                                 "pi",
                                 "E",
                                 "0",
                                 "1/0",
                                 "sqrt(-1)",
                                 "1e999",
                                 "x=1",
                                 "sin(x",
                                 "((((((((",
                                 "x,y",
                                 "x;y",
                                 "a b",
                                 "if(x,1)",
                                 "x?1:2",
                                 "exp(1e9)",
                                 "_",
                                 "\n",
                                 "\t\"'\\",
                                 "\xc3\xa9",
                                 "MUSL",
                                 "TLMPM",
                                 "linear",
                                 "energies",
                                 "-",
                                 "rnd()",
                                 "1e",
                                 "0x1F",
                                 "sum()",
                                 "min()",
                                 "x^y^t^x",
                                 "momentum.x",
                                 "energies.total",
                                 "tip.displacement.y",
                                 "*",
                                 "\"x\""};

/// `message` and all messages in it.
void collect(Message& message, std::vector<Message*>& messages, std::vector<std::string>& strings) {
  messages.push_back(&message);
  const auto& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const bool is_message = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_STRING && !field->is_repeated()) {
      strings.push_back(reflection.GetString(message, field));
    }
    if (is_message && !field->is_repeated())
      collect(*reflection.MutableMessage(&message, field), messages, strings);
    if (!is_message || !field->is_repeated()) continue;
    for (int i = 0; i < reflection.FieldSize(message, field); ++i) {
      collect(*reflection.MutableRepeatedMessage(&message, field, i), messages, strings);
    }
  }
}

}  // namespace

double SceneMutator::make_number(double present) {
  return below(2) == 0 ? any_of(numbers) : present * any_of(factors);
}

std::int32_t SceneMutator::make_integer(std::int32_t present) {
  // Unsigned, so that it wraps instead of overflowing.
  return below(2) == 0 ? any_of(integers)
                       : static_cast<std::int32_t>(static_cast<std::uint32_t>(present) + below(5) - 2u);
}

std::string SceneMutator::make_string(const std::string& present) {
  switch (below(6)) {
    case 0:
      return present + any_of(words);
    case 1:
      return any_of(words) + present;
    case 2:
      return std::string(below(3000), any_of("(x-1 "));
    case 3:
      return strings_.empty() ? present : any_of(strings_);
    case 4:
      return present.substr(0, below(present.size() + 1));
    default:
      return any_of(words);
  }
}

void SceneMutator::set_value(Message& message, const FieldDescriptor& field) {
  const auto& reflection = *message.GetReflection();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.SetDouble(&message, &field, make_number(reflection.GetDouble(message, &field)));
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection.SetInt32(&message, &field, make_integer(reflection.GetInt32(message, &field)));
    case FieldDescriptor::CPPTYPE_BOOL:
      return reflection.SetBool(&message, &field, below(2) == 0);
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection.SetEnumValue(&message, &field, static_cast<int>(below(8)) - 1);
    case FieldDescriptor::CPPTYPE_STRING:
      return reflection.SetString(&message, &field, make_string(reflection.GetString(message, &field)));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      reflection.MutableMessage(&message, &field);
      return;
    default:
      return;
  }
}

void SceneMutator::add_element(Message& message, const FieldDescriptor& field) {
  const auto& reflection = *message.GetReflection();
  const int size = reflection.FieldSize(message, &field);
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.AddDouble(&message, &field, make_number(1));
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection.AddEnumValue(&message, &field, static_cast<int>(below(8)) - 1);
    case FieldDescriptor::CPPTYPE_STRING:
      return reflection.AddString(&message, &field, make_string(""));
    case FieldDescriptor::CPPTYPE_MESSAGE: {
      Message& added = *reflection.AddMessage(&message, &field);
      if (size > 0) added.CopyFrom(reflection.GetRepeatedMessage(message, &field, static_cast<int>(below(size))));
      return;
    }
    default:
      return;
  }
}

void SceneMutator::mutate_repeated(Message& message, const FieldDescriptor& field) {
  const auto& reflection = *message.GetReflection();
  const int size = reflection.FieldSize(message, &field);
  if (size == 0 || (size < 50 && below(3) == 0)) return add_element(message, field);
  const int first = static_cast<int>(below(size));
  const int second = static_cast<int>(below(size));
  reflection.SwapElements(&message, &field, first, second);
  if (below(2) == 0) reflection.RemoveLast(&message, &field);
}

void SceneMutator::mutate_field(Message& message, const FieldDescriptor& field) {
  if (field.is_repeated()) return mutate_repeated(message, field);
  if (below(6) == 0) return message.GetReflection()->ClearField(&message, &field);
  set_value(message, field);
}

void SceneMutator::mutate(v1::Scene& scene) {
  std::vector<Message*> messages;
  strings_.clear();
  collect(scene, messages, strings_);
  Message& message = *any_of(messages);
  const auto& descriptor = *message.GetDescriptor();
  if (descriptor.field_count() == 0) return;
  mutate_field(message, *descriptor.field(static_cast<int>(below(descriptor.field_count()))));
}

std::string SceneMutator::mutate(std::string text) {
  const std::size_t place = below(text.size() + 1);
  const std::size_t length = below(std::min<std::size_t>(text.size() - place, 40) + 1);
  switch (below(5)) {
    case 0:
      return text.erase(place, length);
    case 1:
      return text.insert(place, text.substr(below(text.size() + 1), 60));
    case 2:
      return text.insert(place, any_of(words));
    case 3:
      return text.insert(place, 1 + below(200), any_of("{}[]<>\"'#:;,.-0\n"));
    default:
      if (place < text.size()) text[place] = static_cast<char>(below(256));
      return text;
  }
}

}  // namespace trajan::testing
