// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/utf8.h"

#include <array>

namespace hapticell {

namespace {

/// Bytes of a character that begins so; 0 where none does.
std::size_t lengthBy(unsigned char first) {
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;
  if (first < 0xE0) return 2;
  if (first < 0xF0) return 3;
  return first < 0xF5 ? 4 : 0;
}

}  // namespace

Utf8Character characterAt(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = lengthBy(first);
  if (length == 0) return {};
  if (length == 1) return {first, 1};
  char32_t character = first & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (at + i >= text.size() || !continuesCharacter(text[at + i])) return {kNoCharacter, i};
    character = character << 6 | (static_cast<unsigned char>(text[at + i]) & 0x3F);
  }
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool valid = character >= kLeast[length] && character <= 0x10FFFF && (character < 0xD800 || character > 0xDFFF);
  return {valid ? character : kNoCharacter, length};
}

bool isUtf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [character, length] = characterAt(text, at);
    if (character == kNoCharacter) return false;
    at += length;
  }
  return true;
}

}  // namespace hapticell
