// SPDX-License-Identifier: Apache-2.0
#include "geometry/error.h"

#include <algorithm>

namespace hapticell {

namespace {

constexpr std::size_t kLongest = 300;  // Bytes of one part: files may hold words of any length.

/// One line, of readable length, whatever the file held.
std::string tidy(std::string text) {
  if (text.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // Within a UTF-8 character.
    text.resize(end);
    text += "...";
  }
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
  return text;
}

}  // namespace

std::string Error::message() const {
  std::string text = file;
  if (!place.empty()) text += (text.empty() ? "" : ", ") + tidy(place);
  if (!found.empty()) text += (text.empty() ? "" : ": ") + tidy(found);
  if (!expected.empty()) text += (text.empty() ? "expected " : "; expected ") + tidy(expected);
  if (!fix.empty()) text += (text.empty() ? "" : ". ") + fix;
  return text;
}

}  // namespace hapticell
