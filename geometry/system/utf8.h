// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace hapticell {

/// No character of UTF-8 begins here.
inline constexpr char32_t kNoCharacter = 0xFFFFFFFF;

struct Utf8Character {
  char32_t character = kNoCharacter;
  std::size_t length = 1;  ///< Bytes of the character, or to skip if they are not UTF-8.
};

/// The character at `at` (RFC 3629: shortest form, no surrogates, up to U+10FFFF).
/// @pre at < text.size()
Utf8Character characterAt(std::string_view text, std::size_t at);

/// True for a byte that continues a character and begins none.
constexpr bool continuesCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

bool isUtf8(std::string_view text);

}  // namespace hapticell
