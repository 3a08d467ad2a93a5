#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <set>
#include <string>

/// Questions about messages and their schema, for tests.
namespace trajan::testing {

/// Full names of all fields and enum values of `root` and of the messages that it is built from.
std::set<std::string> schema_of(const google::protobuf::Descriptor& root);

/// Full names of the fields that are set in `message` and of the enum values that they hold.
std::set<std::string> used_by(const google::protobuf::Message& message);

/// Whether `path` ("bodies[0].geometry.disc.radius") names a field of `message`, set or not, or at its
/// end one of its oneofs. Indices must exist.
bool names_a_field(const google::protobuf::Message& message, const std::string& path);

}  // namespace trajan::testing
