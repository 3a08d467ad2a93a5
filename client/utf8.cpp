#include "client/utf8.h"

#include <algorithm>

namespace trajan::client {
namespace {

using Byte = unsigned char;

/// The bytes of the character that begins `text`; 0 if there is none (RFC 3629, section 4).
std::size_t character_length(std::string_view text) {
  const Byte first = static_cast<Byte>(text[0]);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (text.size() < length) return 0;
  const Byte lowest = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const Byte highest = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  const Byte second = static_cast<Byte>(text[1]);
  if (second < lowest || second > highest) return 0;
  const bool rest = std::ranges::all_of(text.substr(2, length - 2),
                                        [](char byte) { return (static_cast<Byte>(byte) & 0xC0) == 0x80; });
  return rest ? length : 0;
}

}  // namespace

std::size_t first_invalid_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::string_view::npos;
}

}  // namespace trajan::client
