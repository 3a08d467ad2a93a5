#pragma once

#include <string>
#include <vector>

#include "client/connection.h"
#include "client/scene_text.h"

namespace trajan::client {

/// A scene and the name under which messages speak of it.
struct LoadedScene {
  std::string file;
  SceneText text;
};

/// Where a scene comes from, and what the command line changes in it.
struct SceneSource {
  std::string name;
  std::vector<std::string> changes;  ///< see field_change.h
};

/// `name`: a file (JSON if it ends in .json), `-` for standard input, or the name of a gallery scene.
/// Throws CommandError if there is no such thing or no such field; mistakes in the scene are in its diagnostics.
LoadedScene load_scene(const SceneSource& source);

/// Prints every mistake of the scene, with the violations that the server found, and throws CommandError (usage).
[[noreturn]] void fail_for_mistakes(const LoadedScene& scene,
                                    const google::protobuf::RepeatedPtrField<v1::Violation>& violations);

/// Asks the server about the scene. Fails as above if it has mistakes.
v1::Plan check_scene(Connection& connection, const LoadedScene& scene);

}  // namespace trajan::client
