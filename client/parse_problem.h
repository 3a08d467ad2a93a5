#pragma once

#include <google/protobuf/descriptor.h>

#include <string>
#include <vector>

namespace trajan::client {

/// A mistake of spelling or form in words for people.
struct ParseProblem {
  std::string message;
  std::string hint;
  std::string meant;  ///< the field that was probably meant, if a name is misspelt
};

/// What is read of the parser's message, which may quote all of a scene: std::regex recurses per character.
inline constexpr std::size_t longest_parser_message = 1000;

/// Puts what protobuf's text parser says into words. `names` is the path of the field in which it happened,
/// from the outermost name on.
ParseProblem explain_parse_problem(const std::string& whole_message, const std::vector<std::string>& names);

/// The message type that holds the last of `names`, which itself need not exist; null if there is none.
const google::protobuf::Descriptor* enclosing_message(const std::vector<std::string>& names);

}  // namespace trajan::client
