// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/xml_text.h"

#include <algorithm>

namespace hapticell::workcell {

namespace {

/// Bytes that should follow one that begins a character of more than one.
std::size_t followers(unsigned char first) {
  if (first >= 0xC2 && first <= 0xDF) return 1;
  if (first >= 0xE0 && first <= 0xEF) return 2;
  return first >= 0xF0 && first <= 0xF4 ? 3 : 0;
}

/// Bytes of the UTF-8 character that begins at `at`; 0: not found.
std::size_t characterLength(const std::string& text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t more = followers(first);
  if (first >= 0x80 && more == 0) return 0;
  if (more >= text.size() - at) return 0;
  for (std::size_t i = at + 1; i <= at + more; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0u) != 0x80u) return 0;
  return 1 + more;
}

void appendLatin1(unsigned char byte, std::string& text) {
  if (byte < 0xA0) {
    text += '?';
    return;
  }
  text += static_cast<char>(0xC0u | (byte >> 6u));
  text += static_cast<char>(0x80u | (byte & 0x3Fu));
}

}  // namespace

XmlText soundXmlText(const std::string& text) {
  XmlText sound;
  sound.text.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t length = characterLength(text, i); length > 0) {
      sound.text.append(text, i, length);
      i += length;
      continue;
    }
    if (sound.replaced++ == 0) {
      const auto end = text.begin() + static_cast<std::ptrdiff_t>(i);
      sound.line = 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
    }
    appendLatin1(static_cast<unsigned char>(text[i++]), sound.text);
  }
  return sound;
}

}  // namespace hapticell::workcell
