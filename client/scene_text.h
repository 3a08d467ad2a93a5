#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "client/scene_outline.h"
#include "trajan/v1/jobs.pb.h"
#include "trajan/v1/scene.pb.h"

namespace trajan::client {

/// One mistake in a scene file.
struct Diagnostic {
  Position position;    ///< line 0: the file as a whole
  int length = 1;       ///< bytes that the caret underlines
  std::string path;     ///< of the field, if it has one
  std::string message;  ///< what is wrong
  std::string hint;     ///< what would be right; may be empty
};

enum class SceneFormat { text, json };

/// A scene as people write it, and what is wrong with it. Never throws because of its content.
class SceneText {
 public:
  /// Larger scenes are refused; it is what a server accepts in one message.
  static constexpr std::size_t max_bytes = 4 << 20;

  /// Reads protobuf text format or protobuf JSON. After a mistake the field that has it is left out and
  /// the rest is read on, so that all mistakes are found at once.
  SceneText(std::string source, SceneFormat format);

  /// Puts the files that meshes name into the scene; relative names begin at `folder`. A file that cannot be
  /// read is a mistake.
  void read_mesh_files(const std::filesystem::path& folder);

  /// Changes a field as `change_field` does; violations of it are no longer looked for in the text. Throws
  /// CommandError.
  void change(const std::string& change);

  /// Complete only if there are no diagnostics; otherwise without the fields that could not be read.
  const v1::Scene& scene() const { return scene_; }
  /// Mistakes of spelling and form, in the order of the text.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  /// Whether the text is UTF-8 and the brackets match, so that a check of the parts that could be read makes
  /// sense.
  bool has_structure() const { return has_structure_; }

  /// The place of a violation that the server found: of the field's value, or of the nearest ancestor that
  /// is written in the text.
  Diagnostic locate(const v1::Violation& violation) const;
  /// `diagnostics()` and the located violations, in the order of the text. Violations that only follow
  /// from a field that could not be read are left out.
  std::vector<Diagnostic> merge(const google::protobuf::RepeatedPtrField<v1::Violation>& violations) const;

  std::string_view line(int number) const { return outline_->line(number); }

 private:
  bool check_utf8();
  bool is_bytes(const SceneOutline::Token& token) const;
  void sort_diagnostics();
  void read_text();
  void read_json();
  bool leave_out(std::size_t offset, const std::string& problem, std::string& text);
  void add_diagnostic(std::size_t offset, std::size_t length, std::string message, std::string hint);

  std::unique_ptr<const std::string> source_;  ///< where it is must not change: the outline looks at it
  std::unique_ptr<const SceneOutline> outline_;
  v1::Scene scene_;
  std::vector<Diagnostic> diagnostics_;
  std::vector<std::string> suspects_;  ///< paths that were left out or probably meant
  std::vector<std::string> changed_;   ///< paths whose values are not those of the text
  bool has_structure_ = true;
};

}  // namespace trajan::client
