#include "client/scene_outline.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>

namespace trajan::client {
namespace {

class IgnoreErrors : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int, int, const std::string&) override {}
};

/// A field's name as the schema spells it: JSON quotes names and may write them in camelCase.
std::string schema_name(const SceneOutline::Token& token) {
  if (!token.string) return token.text;
  std::string name;
  for (const char letter : token.text) {
    if (letter == '"' || letter == '\'') continue;
    if (std::isupper(static_cast<unsigned char>(letter))) {
      name += '_';
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else {
      name += letter;
    }
  }
  return name;
}

}  // namespace

SceneOutline::SceneOutline(std::string_view text) : text_(text) {
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  }
  tokenize();
  const bool json = at("{");
  if (json) ++next_;
  const std::size_t opened = json ? tokens_[0].begin : 0;
  read_message(-1, 0);
  if (json && !structure_error_) {
    if (at("}")) {
      ++next_;
    } else {
      fail(opened, "this { is never closed");
    }
  }
  if (next_ < tokens_.size()) fail(tokens_[next_].begin, "this " + tokens_[next_].text + " closes nothing");
}

void SceneOutline::tokenize() {
  using google::protobuf::io::Tokenizer;
  IgnoreErrors errors;
  google::protobuf::io::ArrayInputStream stream(text_.data(), static_cast<int>(text_.size()));
  Tokenizer tokenizer(&stream, &errors);
  // As the text format's parser reads it.
  tokenizer.set_allow_f_after_float(true);
  tokenizer.set_comment_style(Tokenizer::SH_COMMENT_STYLE);
  tokenizer.set_require_space_after_number(false);
  tokenizer.set_allow_multiline_strings(true);
  Cursor cursor;
  while (tokenizer.Next()) {
    const Tokenizer::Token& token = tokenizer.current();
    const std::size_t begin = advance(cursor, token.line, token.column);
    tokens_.push_back({begin, begin + token.text.size(), token.text, token.type == Tokenizer::TYPE_IDENTIFIER,
                       token.type == Tokenizer::TYPE_STRING});
  }
}

void SceneOutline::fail(std::size_t offset, std::string message) {
  if (!structure_error_) structure_error_ = StructureError{offset, std::move(message)};
  next_ = tokens_.size();
}

int SceneOutline::add_field(std::string name, int parent, std::size_t begin) {
  Field field;
  field.name = std::move(name);
  field.parent = parent;
  field.begin = field.value = field.end = field.statement_begin = field.statement_end = begin;
  fields_.push_back(std::move(field));
  return static_cast<int>(fields_.size()) - 1;
}

void SceneOutline::read_message(int parent, int depth) {
  const std::size_t first = fields_.size();
  while (next_ < tokens_.size() && !ends_block()) {
    if (tokens_[next_].identifier || tokens_[next_].string) {
      read_field(parent, depth);
    } else {
      ++next_;  // a separator, or something that the parser will complain about
    }
  }
  std::map<std::string_view, int> seen;
  for (std::size_t i = first; i < fields_.size(); ++i) {
    if (fields_[i].parent == parent) fields_[i].ordinal = seen[fields_[i].name]++;
  }
}

void SceneOutline::read_field(int parent, int depth) {
  const Token& name = tokens_[next_++];
  const int field = add_field(schema_name(name), parent, name.begin);
  fields_[field].end = fields_[field].statement_end = name.end;
  const bool colon = at(":");
  if (colon) {
    fields_[field].end = fields_[field].statement_end = tokens_[next_].end;
    ++next_;
  }
  if (next_ == tokens_.size() || ends_block()) return;
  if (!colon && tokens_[next_].identifier) return;  // `name name: value`: the first has no value
  if (at("[")) {
    read_list(field, depth);
  } else {
    read_value(field, depth);
    fields_[field].statement_end = fields_[field].end;
  }
}

void SceneOutline::read_value(int field, int depth) {
  fields_[field].value = tokens_[next_].begin;
  if (at("{") || at("<")) {
    read_block(field, depth);
  } else {
    read_scalar(field);
  }
}

void SceneOutline::read_scalar(int field) {
  if (at("-")) ++next_;
  const bool string = next_ < tokens_.size() && tokens_[next_].string;
  if (next_ < tokens_.size() && !ends_block()) ++next_;
  // Strings that follow each other are one value, but not in JSON, where a colon makes the next a name.
  while (string && next_ < tokens_.size() && tokens_[next_].string &&
         !(next_ + 1 < tokens_.size() && tokens_[next_ + 1].text == ":")) {
    ++next_;
  }
  fields_[field].end = tokens_[next_ - 1].end;
}

void SceneOutline::read_block(int field, int depth) {
  const Token& opening = tokens_[next_++];
  fields_[field].is_message = true;
  if (depth == max_depth) {
    return fail(opening.begin, "nested deeper than " + std::to_string(max_depth) + " levels");
  }
  read_message(field, depth + 1);
  fields_[field].end = next_ < tokens_.size() ? tokens_[next_].end : text_.size();
  if (structure_error_) return;
  if (at(opening.text == "{" ? "}" : ">")) {
    ++next_;
  } else if (next_ == tokens_.size()) {
    fail(opening.begin, "this " + opening.text + " is never closed");
  } else {
    fail(tokens_[next_].begin, "this " + tokens_[next_].text + " does not close the " + opening.text +
                                   " of line " + std::to_string(position(opening.begin).line));
  }
}

void SceneOutline::read_list(int field, int depth) {
  const std::size_t opening = tokens_[next_++].begin;
  const std::size_t first = fields_.size();
  const std::string name = fields_[field].name;
  const int parent = fields_[field].parent;
  const std::size_t begin = fields_[field].begin;
  fields_[field].value = opening;
  bool any = false;
  while (next_ < tokens_.size() && !ends_block()) {
    if (at(",")) {
      ++next_;
      continue;
    }
    const int element = any ? add_field(name, parent, tokens_[next_].begin) : field;
    fields_[element].begin = tokens_[next_].begin;
    fields_[element].later_element = any;
    any = true;
    read_value(element, depth);
  }
  if (structure_error_) return;
  if (!at("]")) return fail(opening, "this [ is never closed");
  const std::size_t end = tokens_[next_++].end;
  if (!any) fields_[field].end = end;
  fields_[field].statement_end = end;
  for (std::size_t i = first; i < fields_.size(); ++i) {
    if (fields_[i].parent != parent) continue;
    fields_[i].statement_begin = begin;
    fields_[i].statement_end = end;
  }
}

std::size_t SceneOutline::token_at(std::size_t offset) const {
  const auto token = std::partition_point(tokens_.begin(), tokens_.end(),
                                          [offset](const Token& candidate) { return candidate.end <= offset; });
  return static_cast<std::size_t>(token - tokens_.begin());
}

int SceneOutline::field_around(std::size_t offset) const {
  int innermost = -1;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    // Fields are in the order of their begin, so that a later one that fits lies inside an earlier one. The
    // first element stands for the list's brackets and commas.
    const Field& field = fields_[i];
    const std::size_t begin = field.later_element ? field.begin : field.statement_begin;
    const std::size_t end = field.later_element ? field.end : field.statement_end;
    if (begin <= offset && offset < end) innermost = static_cast<int>(i);
  }
  return innermost;
}

SceneOutline::Match SceneOutline::find(std::string_view path) const {
  Match match;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    std::string_view name = path.substr(0, dot);
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
    int ordinal = 0;
    if (const std::size_t bracket = name.find('['); bracket != std::string_view::npos) {
      std::from_chars(name.data() + bracket + 1, name.data() + name.size(), ordinal);
      name = name.substr(0, bracket);
    }
    const auto field = std::find_if(fields_.begin(), fields_.end(), [&](const Field& candidate) {
      return candidate.parent == match.field && candidate.ordinal == ordinal && candidate.name == name;
    });
    if (field == fields_.end()) {
      match.full = false;
      return match;
    }
    match.field = static_cast<int>(field - fields_.begin());
  }
  return match;
}

std::vector<std::string> SceneOutline::names(int field) const {
  std::vector<std::string> names;
  for (; field != -1; field = fields_[field].parent) names.insert(names.begin(), fields_[field].name);
  return names;
}

Position SceneOutline::position(std::size_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = next - line_starts_.begin();
  return {static_cast<int>(line), static_cast<int>(offset - line_starts_[line - 1]) + 1};
}

std::size_t SceneOutline::offset(int line, int column) const {
  Cursor start;
  return advance(start, line, column);
}

std::size_t SceneOutline::advance(Cursor& cursor, int line, int column) const {
  if (line >= static_cast<int>(line_starts_.size())) return text_.size();
  if (line != cursor.line) cursor = {line, 0, line_starts_[line]};
  for (; cursor.column < column && cursor.offset < text_.size(); ++cursor.offset) {
    cursor.column += text_[cursor.offset] == '\t' ? 8 - cursor.column % 8 : 1;
  }
  return cursor.offset;
}

std::string_view SceneOutline::line(int number) const {
  if (number < 1 || number > static_cast<int>(line_starts_.size())) return {};
  const std::size_t begin = line_starts_[number - 1];
  const std::string_view rest = text_.substr(begin);
  return rest.substr(0, std::min(rest.find('\n'), rest.find('\r')));
}

}  // namespace trajan::client
