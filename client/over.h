#pragma once

#include <string>

#include "trajan/v1/studies.pb.h"

namespace trajan::client {

/// A dial as the command line says it: `PATH=VALUE,VALUE,...`, each value as in a scene file, or
/// `PATH=FROM:TO:COUNT`, so many numbers at equal distances with both ends. Commas inside brackets, braces and
/// quotes belong to the value. Throws CommandError (usage).
v1::Dial parse_over(const std::string& text);

}  // namespace trajan::client
