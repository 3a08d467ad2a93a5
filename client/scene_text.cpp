#include "client/scene_text.h"

#include <fmt/format.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <regex>

#include "client/field_change.h"
#include "client/mesh_files.h"
#include "client/parse_problem.h"
#include "client/utf8.h"

namespace trajan::client {
namespace {

struct ParserError {
  int line;    ///< from 0 on
  int column;  ///< from 0 on, tabs go to multiples of 8
  std::string message;
};

class ErrorList : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, int column, const std::string& message) override {
    errors.push_back({line, column, message});
  }
  std::vector<ParserError> errors;
};

std::vector<ParserError> parse(const std::string& text, v1::Scene& scene) {
  ErrorList list;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&list);
  parser.SetRecursionLimit(SceneOutline::max_depth + 1);
  if (parser.ParseFromString(text, &scene)) list.errors.clear();
  return list.errors;
}

/// The token that an error is about. The parser reports many errors after it has read past the token; then
/// the one before is the one whose text the message quotes.
std::size_t offending_token(const SceneOutline& outline, std::size_t offset, const std::string& message) {
  const std::size_t token = outline.token_at(offset);
  if (token == 0) return 0;
  const std::vector<SceneOutline::Token>& tokens = outline.tokens();
  const bool about_this = token < tokens.size() && message.find("Expected ") != std::string::npos &&
                          message.find(tokens[token].text) != std::string::npos;
  const bool about_last = message.find('"' + tokens[token - 1].text + '"') != std::string::npos;
  return (about_last && !about_this) || token == tokens.size() ? token - 1 : token;
}

/// Replaces text by blanks so that everything else keeps its place.
void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    if (text[i] != '\n' && text[i] != '\t') text[i] = ' ';
  }
}

/// The dotted path of a field, with an index where the schema has a list on the way to it.
std::string schema_path(const SceneOutline& outline, int field) {
  std::vector<int> chain;
  for (int i = field; i != -1; i = outline.fields()[i].parent) chain.insert(chain.begin(), i);
  std::string path;
  for (const int link : chain) {
    const SceneOutline::Field& at = outline.fields()[link];
    const google::protobuf::Descriptor* message = enclosing_message(outline.names(link));
    const auto* descriptor = message == nullptr ? nullptr : message->FindFieldByName(at.name);
    path += path.empty() ? at.name : "." + at.name;
    // A list itself may be meant: what is left out of it may leave it empty.
    if (link != field && descriptor != nullptr && descriptor->is_repeated())
      path += fmt::format("[{}]", at.ordinal);
  }
  return path;
}

bool is_at_or_below(std::string_view path, std::string_view ancestor) {
  if (!path.starts_with(ancestor)) return false;
  return path.size() == ancestor.size() || path[ancestor.size()] == '.' || path[ancestor.size()] == '[';
}

bool is_at_or_below_any(std::string_view path, const std::vector<std::string>& ancestors) {
  return std::ranges::any_of(ancestors,
                             [&](const std::string& ancestor) { return is_at_or_below(path, ancestor); });
}

}  // namespace

SceneText::SceneText(std::string source, SceneFormat format) {
  const bool too_large = source.size() > max_bytes;
  const std::size_t size = source.size();
  if (too_large) source.clear();
  source_ = std::make_unique<const std::string>(std::move(source));
  outline_ = std::make_unique<const SceneOutline>(*source_);
  if (too_large) {
    has_structure_ = false;
    diagnostics_.push_back({{},
                            1,
                            {},
                            fmt::format("the scene has {} bytes", size),
                            fmt::format("at most {} are accepted", max_bytes)});
    return;
  }
  if (!check_utf8()) {
    has_structure_ = false;
    return;
  }
  if (const auto& error = outline_->structure_error()) {
    has_structure_ = false;
    add_diagnostic(error->offset, 1, error->message, {});
    return;
  }
  if (format == SceneFormat::json) {
    read_json();
  } else {
    read_text();
  }
  sort_diagnostics();
}

/// Whether the token stands where the schema has bytes instead of text.
bool SceneText::is_bytes(const SceneOutline::Token& token) const {
  const int field = outline_->field_around(token.begin);
  return field >= 0 && outline_->fields()[static_cast<std::size_t>(field)].name == "stl";
}

void SceneText::sort_diagnostics() {
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.position.line, a.position.column) < std::pair(b.position.line, b.position.column);
  });
}

void SceneText::read_mesh_files(const std::filesystem::path& folder) {
  if (!has_structure_) return;
  for (const MeshFileError& error : embed_mesh_files(scene_, folder, max_bytes)) {
    v1::Violation violation;
    violation.set_path(error.path);
    violation.set_value(error.file);
    violation.set_problem(error.problem);
    violation.set_remedy("name an STL file; all of a scene's together may have 4 MiB");
    diagnostics_.push_back(locate(violation));
    suspects_.push_back(error.path.substr(0, error.path.rfind('.')));
  }
  sort_diagnostics();
}

bool SceneText::check_utf8() {
  const std::size_t wrong = first_invalid_utf8(*source_);
  if (wrong != std::string_view::npos) {
    const auto byte = static_cast<unsigned char>((*source_)[wrong]);
    add_diagnostic(wrong, 1, fmt::format("the byte 0x{:02X} is not valid UTF-8", byte),
                   "save the scene as UTF-8; from Latin-1: iconv -f latin1 -t utf-8");
    return false;
  }
  // Escapes such as \xe4 can make text that is not.
  for (const SceneOutline::Token& token : outline_->tokens()) {
    if (!token.string || token.text.find('\\') == std::string::npos) continue;
    std::string meant;
    google::protobuf::io::Tokenizer::ParseString(token.text, &meant);
    if (first_invalid_utf8(meant) == std::string_view::npos || is_bytes(token)) continue;
    add_diagnostic(token.begin, token.end - token.begin, "the escapes in this text make bytes that are not UTF-8",
                   "write the characters themselves, or \\u00e4 for the character U+00E4");
  }
  return diagnostics_.empty();
}

void SceneText::read_text() {
  constexpr int most_mistakes = 100;  // nobody reads more at once
  std::string text = *source_;
  for (int i = 0; i < most_mistakes; ++i) {
    const std::vector<ParserError> errors = parse(text, scene_);
    if (errors.empty()) return;
    const ParserError& first = errors.front();
    if (!leave_out(outline_->offset(first.line, first.column), first.message, text)) return;
  }
}

bool SceneText::leave_out(std::size_t offset, const std::string& problem, std::string& text) {
  const std::size_t number = offending_token(*outline_, offset, problem);
  if (number >= outline_->tokens().size()) {
    add_diagnostic(offset, 1, explain_parse_problem(problem, {}).message, {});
    return false;
  }
  const SceneOutline::Token& token = outline_->tokens()[number];
  const int field = outline_->field_around(token.begin);
  const ParseProblem explained =
      explain_parse_problem(problem, field == -1 ? std::vector<std::string>() : outline_->names(field));
  add_diagnostic(token.begin, token.end - token.begin, explained.message, explained.hint);
  if (field == -1) {
    blank(text, token.begin, token.end);
    return true;
  }
  const SceneOutline::Field& left_out = outline_->fields()[field];
  diagnostics_.back().path = schema_path(*outline_, field);
  suspects_.push_back(diagnostics_.back().path);
  if (!explained.meant.empty()) {
    const std::string& path = suspects_.back();
    suspects_.push_back(path.substr(0, path.size() - left_out.name.size()) + explained.meant);
  }
  if (text[left_out.statement_begin] == ' ') return false;  // left out already: no progress
  blank(text, left_out.statement_begin, left_out.statement_end);
  return true;
}

void SceneText::read_json() {
  const auto status = google::protobuf::util::JsonStringToMessage(*source_, &scene_);
  if (status.ok()) return;
  const std::string said = std::string(status.message()).substr(0, longest_parser_message);
  static const std::regex at_field(R"re(^\(?([\w.\[\]]*)\)?:? ?(.*): (Cannot find field\.)$)re");
  std::smatch match;
  if (std::regex_match(said, match, at_field)) {
    const std::string path = match[1].length() == 0 ? match[2].str() : match[1].str() + "." + match[2].str();
    const SceneOutline::Match found = outline_->find(path);
    std::vector<std::string> names = outline_->names(found.field);
    if (!found.full) names.push_back(match[2].str());
    const ParseProblem problem =
        explain_parse_problem(fmt::format("has no field named \"{}\"", match[2].str()), names);
    const std::size_t begin = found.field == -1 ? 0 : outline_->fields()[found.field].begin;
    const std::size_t length = outline_->tokens()[outline_->token_at(begin)].text.size();
    return add_diagnostic(begin, length, problem.message, problem.hint);
  }
  diagnostics_.push_back({{}, 1, {}, said.substr(0, said.find('\n')), {}});
}

void SceneText::add_diagnostic(std::size_t offset, std::size_t length, std::string message, std::string hint) {
  diagnostics_.push_back(
      {outline_->position(offset), static_cast<int>(length), {}, std::move(message), std::move(hint)});
}

void SceneText::change(const std::string& change) { changed_.push_back(change_field(scene_, change)); }

Diagnostic SceneText::locate(const v1::Violation& violation) const {
  Diagnostic diagnostic;
  diagnostic.path = violation.path();
  diagnostic.message =
      violation.path().empty() ? violation.problem() : violation.path() + ": " + violation.problem();
  // A name that the problem quotes need not be said again.
  const bool is_quoted = violation.problem().find('"' + violation.value() + '"') != std::string::npos;
  if (!violation.value().empty() && !is_quoted) diagnostic.message += fmt::format(" (got {})", violation.value());
  diagnostic.hint = violation.remedy();
  if (is_at_or_below_any(violation.path(), changed_)) return diagnostic;
  const SceneOutline::Match match = outline_->find(violation.path());
  if (match.field == -1) return diagnostic;
  const SceneOutline::Field& field = outline_->fields()[match.field];
  const bool at_value = match.full && !field.is_message;
  const std::size_t begin = at_value ? field.value : field.begin;
  const std::size_t name_end =
      field.is_message ? outline_->tokens()[outline_->token_at(field.begin)].end : field.end;
  diagnostic.position = outline_->position(begin);
  diagnostic.length = static_cast<int>((at_value ? field.end : name_end) - begin);
  return diagnostic;
}

std::vector<Diagnostic> SceneText::merge(
    const google::protobuf::RepeatedPtrField<v1::Violation>& violations) const {
  std::vector<Diagnostic> all = diagnostics_;
  for (const v1::Violation& violation : violations) {
    if (!is_at_or_below_any(violation.path(), suspects_)) all.push_back(locate(violation));
  }
  std::stable_sort(all.begin(), all.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.position.line, a.position.column) < std::pair(b.position.line, b.position.column);
  });
  return all;
}

}  // namespace trajan::client
