// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/error.h"

#include <cstring>

#include "geometry/system/plain_text.h"

namespace hapticell {

std::string Error::message() const {
  constexpr std::size_t kLongestPath = 4096;
  std::string text = plainText(file, kLongestPath);
  if (!place.empty()) text += (text.empty() ? "" : ", ") + plainText(english(place));
  if (!found.empty()) text += (text.empty() ? "" : ": ") + plainText(english(found));
  if (!expected.empty()) text += (text.empty() ? "expected " : "; expected ") + plainText(english(expected));
  if (!fix.empty()) text += (text.empty() ? "" : ". ") + plainText(english(fix), 2 * kLongestText);
  return text;
}

Text wholeText(const Error& error) {
  Text text = error.found;
  if (!error.place.empty()) text = Text("%1: %2", error.place, text);
  if (!error.file.empty())
    text = error.place.empty() ? Text("%1: %2", error.file, text) : Text("%1, %2", error.file, text);
  if (!error.expected.empty()) text = Text("%1; expected %2", text, error.expected);
  return error.fix.empty() ? text : Text("%1. %2", text, error.fix);
}

Text systemText(int error_number) {
  return std::string(std::strerror(error_number));
}

}  // namespace hapticell
