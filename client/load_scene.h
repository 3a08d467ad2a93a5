#pragma once

#include <string>

#include "client/connection.h"
#include "client/scene_text.h"

namespace trajan::client {

/// A scene and the name under which messages speak of it.
struct LoadedScene {
  std::string file;
  SceneText text;
};

/// `source`: a file (JSON if it ends in .json), `-` for standard input, or the name of a gallery scene.
/// Throws CommandError if there is no such thing; mistakes in the scene are in its diagnostics.
LoadedScene load_scene(const std::string& source);

/// Prints every mistake of the scene, with the violations that the server found, and throws CommandError (usage).
[[noreturn]] void fail_for_mistakes(const LoadedScene& scene,
                                    const google::protobuf::RepeatedPtrField<v1::Violation>& violations);

/// Asks the server about the scene. Fails as above if it has mistakes.
v1::Plan check_scene(Connection& connection, const LoadedScene& scene);

}  // namespace trajan::client
