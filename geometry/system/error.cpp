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

Text Error::text() const {
  Text all = file;
  if (!place.empty()) all = all.empty() ? place : Text("%1, %2", all, place);
  if (!found.empty()) all = all.empty() ? found : Text("%1: %2", all, found);
  if (!expected.empty()) all = all.empty() ? Text("expected %1", expected) : Text("%1; expected %2", all, expected);
  if (!fix.empty()) all = all.empty() ? fix : Text("%1. %2", all, fix);
  return all;
}

Text systemText(int error_number) {
  return std::string(std::strerror(error_number));
}

}  // namespace hapticell
