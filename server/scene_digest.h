#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "trajan/v1/scene.pb.h"
#include "trajan/v1/studies.pb.h"

namespace trajan {

/// Equal messages give equal bytes, also if they hold maps.
std::string deterministic_bytes(const google::protobuf::Message& message);

/// Of a scene and the solver's version: what has the same digest has the same answer, to the bit. SHA-256 in
/// hexadecimal.
std::string scene_digest(const v1::Scene& scene);

/// Of what scenes have in common that differ only in their settings, name and comments.
std::string family_digest(v1::Scene scene);

/// The settings of a scene, its defaults told.
v1::Settings settings_of(const v1::Scene& scene);

}  // namespace trajan
