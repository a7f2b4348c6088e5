// SPDX-License-Identifier: Apache-2.0
#include "workcell/text/xml_text.h"

#include <algorithm>

#include "geometry/system/utf8.h"

namespace hapticell::workcell {

namespace {

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
    if (const auto [character, length] = characterAt(text, i); character != kNoCharacter) {
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
