#include "client/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include "client/diagnostics.h"
#include "client/gallery.h"
#include "client/terminal.h"
#include "proto/suggestion.h"

namespace trajan::client {
namespace {

/// One byte more than is accepted, so that too much is noticed but endless input is not read.
std::string read_all(std::istream& in) {
  std::string text(SceneText::max_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::optional<std::string> gallery_text(const std::string& name) {
  for (const GalleryScene& scene : gallery()) {
    if (scene.name == name) return std::string(scene.text);
  }
  return std::nullopt;
}

[[noreturn]] void no_such_scene(const std::string& source) {
  std::vector<std::string> names;
  for (const GalleryScene& scene : gallery()) names.emplace_back(scene.name);
  throw CommandError(ExitCode::not_found, fmt::format("there is no file and no gallery scene \"{}\"", source),
                     suggest(source, names, "`trajan scenes` lists the gallery:"));
}

LoadedScene read_scene(const std::string& source) {
  if (source == "-") return {"<standard input>", SceneText(read_all(std::cin), SceneFormat::text)};
  if (std::filesystem::exists(source)) {
    std::ifstream file(source, std::ios::binary);
    if (!file || std::filesystem::is_directory(source)) {
      throw CommandError(ExitCode::not_found, fmt::format("\"{}\" cannot be read", source));
    }
    const bool json = std::filesystem::path(source).extension() == ".json";
    return {source, SceneText(read_all(file), json ? SceneFormat::json : SceneFormat::text)};
  }
  if (const auto text = gallery_text(source)) return {source, SceneText(*text, SceneFormat::text)};
  no_such_scene(source);
}

}  // namespace

LoadedScene load_scene(const SceneSource& source) {
  LoadedScene scene = read_scene(source.name);
  if (scene.text.diagnostics().empty()) {
    for (const std::string& change : source.changes) scene.text.change(change);
  }
  // Of standard input and of gallery scenes this is the current folder.
  scene.text.read_mesh_files(std::filesystem::path(source.name).parent_path());
  return scene;
}

void fail_for_mistakes(const LoadedScene& scene,
                       const google::protobuf::RepeatedPtrField<v1::Violation>& violations) {
  const std::vector<Diagnostic> mistakes = scene.text.merge(violations);
  for (const Diagnostic& mistake : mistakes) {
    fmt::print(stderr, "{}", format_diagnostic(mistake, scene.text, scene.file, use_colours()));
  }
  throw CommandError(ExitCode::usage, fmt::format("{} has {} mistake{}", scene.file, mistakes.size(),
                                                  mistakes.size() == 1 ? "" : "s"));
}

v1::Plan check_scene(Connection& connection, const LoadedScene& scene) {
  if (!scene.text.has_structure()) fail_for_mistakes(scene, {});
  v1::CheckSceneRequest request;
  *request.mutable_scene() = scene.text.scene();
  const auto response = connection.call(&v1::Jobs::Stub::CheckScene, request);
  const bool valid = response.violations().empty() && scene.text.diagnostics().empty();
  if (!valid) fail_for_mistakes(scene, response.violations());
  return response.plan();
}

}  // namespace trajan::client
