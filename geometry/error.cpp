// SPDX-License-Identifier: Apache-2.0
#include "geometry/error.h"

namespace hapticell {

std::string Error::message() const {
  std::string text = file;
  if (!place.empty()) text += (text.empty() ? "" : ", ") + place;
  if (!found.empty()) text += (text.empty() ? "" : ": ") + found;
  if (!expected.empty()) text += (text.empty() ? "expected " : "; expected ") + expected;
  if (!fix.empty()) text += (text.empty() ? "" : ". ") + fix;
  return text;
}

}  // namespace hapticell
