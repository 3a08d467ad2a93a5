#pragma once

#include <cstddef>
#include <string_view>

namespace trajan::client {

/// The offset of the first byte that does not belong to a character of UTF-8 as RFC 3629 defines it (no
/// overlong forms, no surrogates, nothing above U+10FFFF); npos if there is none.
std::size_t first_invalid_utf8(std::string_view text);

}  // namespace trajan::client
