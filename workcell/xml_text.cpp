// SPDX-License-Identifier: Apache-2.0
#include "workcell/xml_text.h"

#include <algorithm>
#include <utility>

namespace hapticell::workcell {

namespace {

/// Bytes that should follow one that begins a character of more than one.
std::size_t followers(unsigned char first) {
  if (first >= 0xC2 && first <= 0xDF) return 1;
  if (first >= 0xE0 && first <= 0xEF) return 2;
  return first >= 0xF0 && first <= 0xF4 ? 3 : 0;
}

}  // namespace

XmlText soundXmlText(std::string text) {
  XmlText sound{std::move(text)};
  std::string& bytes = sound.text;
  for (std::size_t i = 0; i < bytes.size();) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    const std::size_t more = followers(byte);
    std::size_t found = 0;
    while (found < more && i + found + 1 < bytes.size() &&
           (static_cast<unsigned char>(bytes[i + found + 1]) & 0xC0u) == 0x80u)
      ++found;
    if (byte < 0x80 || (more > 0 && found == more)) {
      i += 1 + more;
      continue;
    }
    if (sound.replaced++ == 0) {
      const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(i);
      sound.line = 1 + static_cast<std::size_t>(std::count(bytes.begin(), end, '\n'));
    }
    bytes[i++] = '?';
  }
  return sound;
}

}  // namespace hapticell::workcell
