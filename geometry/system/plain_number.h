// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace hapticell {

/// A number as std::snprintf() writes it in the "C" locale: with '.' as decimal point whatever the user's locale is.
/// For all that a program reads again. `format` fixed: `digits` behind the point (%.*f); general: significant ones
/// (%.*g).
inline std::string plainNumber(double value, std::chars_format format, int digits) {
  std::array<char, 400> text{};  // 1e308 has 309 digits before the point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, digits).ptr;
  return {text.data(), end};
}

}  // namespace hapticell
