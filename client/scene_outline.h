#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trajan::client {

/// A place in a file, both from 1 on; columns count bytes. Line 0: no place is known.
struct Position {
  int line = 0;
  int column = 0;
  bool operator==(const Position&) const = default;
};

/// Where the fields of a scene stand in its text (protobuf text format or JSON), found without knowing
/// which fields exist. Also describes text that does not parse, as far as its brackets allow.
class SceneOutline {
 public:
  struct Token {
    std::size_t begin = 0;  ///< byte offset
    std::size_t end = 0;
    std::string text;
    bool identifier = false;
    bool string = false;
  };
  /// One field, or one element of a list `name: [a, b]`.
  struct Field {
    std::string name;
    int ordinal = 0;  ///< among the fields of this name in the same message
    int parent = -1;  ///< index of the enclosing field; -1 for the scene itself
    std::size_t begin = 0;
    std::size_t value = 0;            ///< where the value begins; `begin` if there is none
    std::size_t end = 0;              ///< past the value
    std::size_t statement_begin = 0;  ///< for a list element, of the whole `name: [...]`; otherwise `begin`
    std::size_t statement_end = 0;
    bool is_message = false;
    bool later_element = false;  ///< of a list, not the first
  };
  struct StructureError {
    std::size_t offset = 0;
    std::string message;
  };

  static constexpr int max_depth = 100;

  explicit SceneOutline(std::string_view text);

  const std::vector<Token>& tokens() const { return tokens_; }
  const std::vector<Field>& fields() const { return fields_; }
  /// Brackets that do not match, or messages nested deeper than `max_depth`.
  const std::optional<StructureError>& structure_error() const { return structure_error_; }

  /// The token at a byte offset or the next one after it; the number of tokens at the end.
  std::size_t token_at(std::size_t offset) const;
  /// The innermost field around a byte offset; -1 if it lies outside all fields.
  int field_around(std::size_t offset) const;

  struct Match {
    int field = -1;    ///< -1: not even the first name of the path is there
    bool full = true;  ///< false: only an ancestor was found
  };
  /// The field with a path such as `bodies[0].geometry.disc.radius`, or its nearest ancestor.
  Match find(std::string_view path) const;
  /// The path of a field, its names from the outermost on.
  std::vector<std::string> names(int field) const;

  Position position(std::size_t offset) const;
  /// The byte offset of a tokenizer's place: from 0 on, with tabs that go to the next multiple of 8.
  std::size_t offset(int line, int column) const;
  std::string_view line(int number) const;

 private:
  /// A place that only moves on, so that reading a long line takes time in proportion to its length.
  struct Cursor {
    int line = 0;
    int column = 0;
    std::size_t offset = 0;
  };

  void tokenize();
  std::size_t advance(Cursor& cursor, int line, int column) const;
  void read_message(int parent, int depth);
  void read_field(int parent, int depth);
  void read_value(int field, int depth);
  void read_list(int field, int depth);
  void read_block(int field, int depth);
  void read_scalar(int field);
  int add_field(std::string name, int parent, std::size_t begin);
  bool at(std::string_view symbol) const { return next_ < tokens_.size() && tokens_[next_].text == symbol; }
  bool ends_block() const { return at("}") || at(">") || at("]"); }
  void fail(std::size_t offset, std::string message);

  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  std::vector<Token> tokens_;
  std::vector<Field> fields_;
  std::optional<StructureError> structure_error_;
  std::size_t next_ = 0;
};

}  // namespace trajan::client
