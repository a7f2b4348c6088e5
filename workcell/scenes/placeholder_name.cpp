// SPDX-License-Identifier: Apache-2.0
#include "workcell/scenes/placeholder_name.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "geometry/system/text_case.h"

namespace hapticell::workcell {

namespace {

/// In small letters; numbers may follow.
constexpr std::array<std::string_view, 12> kPlaceholders{
    "default", "document",     "no name", "noname",           "none",    "null",
    "product", "product name", "unknown", "the product name", "unnamed", "untitled"};

}  // namespace

bool saysNothing(std::string_view name) {
  const auto isWord = [](char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte >= 0x80 || std::isalnum(byte) != 0;
  };
  if (std::none_of(name.begin(), name.end(), isWord)) return true;
  const std::size_t end = name.find_last_not_of("0123456789 ._-:");
  const std::string word = lowerCase(name.substr(0, end + 1));
  return std::find(kPlaceholders.begin(), kPlaceholders.end(), word) != kPlaceholders.end();
}

}  // namespace hapticell::workcell
