#include "proto/field_change.h"

#include <fmt/format.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <charconv>
#include <optional>
#include <vector>

#include "proto/suggestion.h"

namespace trajan {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::TextFormat;

[[noreturn]] void refuse(const std::string& problem, const std::string& hint) {
  throw FieldChangeError(problem, hint);
}

/// Keeps what the parser says first.
class FirstError : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int, int, const std::string& message) override {
    if (first.empty()) first = message;
  }
  std::string first;
};

/// One word of a path: a field, and an element of it if it is followed by brackets.
struct Word {
  std::string field;
  std::optional<std::string> element;
};

class Change {
 public:
  Change(v1::Scene& scene, const std::string& change) : message_(&scene) {
    const std::size_t equals = change.find('=');
    if (equals == 0 || equals == std::string::npos) refuse("it is not PATH=VALUE", "as in domain.cell_size=0.1");
    value_ = change.substr(equals + 1);
    read_path(change.substr(0, equals));
  }

  std::string perform() {
    for (std::size_t i = 0; i + 1 < words_.size(); ++i) step_into(words_[i]);
    if (words_.back().element) {
      step_into(words_.back());
      message_->Clear();
      merge(value_.starts_with('{') && value_.ends_with('}') ? value_.substr(1, value_.size() - 2) : value_);
    } else {
      replace(words_.back().field);
    }
    return path_;
  }

 private:
  /// Names of elements may have dots in them.
  void read_path(const std::string& path) {
    for (std::size_t at = 0; at <= path.size();) {
      Word word;
      const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
      word.field = path.substr(at, end - at);
      at = end + 1;
      if (end < path.size() && path[end] == '[') {
        const std::size_t close = path.find(']', end);
        if (close == std::string::npos || (close + 1 < path.size() && path[close + 1] != '.'))
          refuse("the brackets do not match", "as in bodies[0].material=soft");
        word.element = path.substr(end + 1, close - end - 1);
        at = close + 2;
      }
      words_.push_back(word);
    }
  }

  const FieldDescriptor& find(const std::string& name) {
    const auto& type = *message_->GetDescriptor();
    if (const FieldDescriptor* field = type.FindFieldByName(name)) return *field;
    std::vector<std::string> names;
    for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
    refuse(fmt::format("there is no field \"{}\" in {}", name, path_.empty() ? "a scene" : path_),
           suggest(name, names, "the fields are"));
  }

  void step_into(const Word& word) {
    const FieldDescriptor& field = find(word.field);
    const auto& access = *message_->GetReflection();
    extend_path(word.field);
    if (field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE)
      refuse(path_ + " has no fields", "it is a single value");
    if (!field.is_repeated()) {
      if (word.element) refuse(path_ + " is not a list", "leave the brackets out");
      message_ = access.MutableMessage(message_, &field);
      return;
    }
    const int index = element_of(field, word.element);
    path_ += fmt::format("[{}]", index);
    message_ = access.MutableRepeatedMessage(message_, &field, index);
  }

  /// By number, or the one whose field `name` is this.
  int element_of(const FieldDescriptor& list, const std::optional<std::string>& element) {
    const auto& access = *message_->GetReflection();
    const int size = access.FieldSize(*message_, &list);
    std::vector<std::string> names;
    const FieldDescriptor* name = list.message_type()->FindFieldByName("name");
    for (int i = 0; name && i < size; ++i) {
      const Message& entry = access.GetRepeatedMessage(*message_, &list, i);
      names.push_back(entry.GetReflection()->GetString(entry, name));
      if (element == names.back()) return i;
    }
    if (!element) refuse(path_ + " is a list", "say which: " + path_ + "[0] is the first");
    int index = -1;
    const auto [end, error] = std::from_chars(element->data(), element->data() + element->size(), index);
    const bool number = error == std::errc() && end == element->data() + element->size();
    if (number && index >= 0 && index < size) return index;
    if (number) refuse(fmt::format("{} has {} elements, counted from 0", path_, size), "");
    refuse(fmt::format("no element of {} has the name \"{}\"", path_, *element),
           suggest(*element, names, "there are"));
  }

  void replace(const std::string& name) {
    const FieldDescriptor& field = find(name);
    extend_path(name);
    message_->GetReflection()->ClearField(message_, &field);
    const bool text = field.type() == FieldDescriptor::TYPE_STRING && !value_.starts_with('"');
    if (text && !field.is_repeated()) {
      message_->GetReflection()->SetString(message_, &field, value_);
    } else {
      merge(name + ": " + value_);
    }
  }

  void merge(const std::string& text) {
    FirstError error;
    TextFormat::Parser parser;
    parser.RecordErrorsTo(&error);
    if (!parser.MergeFromString(text, message_))
      refuse(error.first.empty() ? "the value cannot be read" : error.first, "write it as in a scene file");
  }

  void extend_path(const std::string& name) { path_ += (path_.empty() ? "" : ".") + name; }

  Message* message_;  ///< what the path has reached
  std::vector<Word> words_;
  std::string value_;
  std::string path_;
};

}  // namespace

std::string change_field(v1::Scene& scene, const std::string& change) { return Change(scene, change).perform(); }

}  // namespace trajan
