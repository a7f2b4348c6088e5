// SPDX-License-Identifier: Apache-2.0
#include "geometry/system/plain_text.h"

#include <algorithm>
#include <array>

#include "geometry/system/utf8.h"

namespace hapticell {

namespace {

constexpr std::string_view kUnknown = "\xEF\xBF\xBD", kCut = "...";

struct Range {
  char32_t first, last;
};

// Unicode: Cc, Zl, Zp.
constexpr std::array kBlanks = {Range{0x00, 0x1F}, Range{0x7F, 0x9F}, Range{0x2028, 0x2029}};

// Unicode: Cf that turns the direction or is not seen, unassigned marks for hidden text, private ends. The joiners
// U+200C and U+200D stay: Persian and Indian scripts are written with them.
constexpr std::array kHidden = {
    Range{0x00AD, 0x00AD}, Range{0x034F, 0x034F}, Range{0x061C, 0x061C},   Range{0x115F, 0x1160},
    Range{0x17B4, 0x17B5}, Range{0x180B, 0x180F}, Range{0x200B, 0x200B},   Range{0x200E, 0x200F},
    Range{0x202A, 0x202E}, Range{0x2060, 0x206F}, Range{0x3164, 0x3164},   Range{0xFE00, 0xFE0E},
    Range{0xFEFF, 0xFEFF}, Range{0xFFA0, 0xFFA0}, Range{0xFFF0, 0xFFFB},   Range{0x1BCA0, 0x1BCA3},
    Range{0xFDD0, 0xFDEF}, Range{0xFFFE, 0xFFFF}, Range{0x1D173, 0x1D17A}, Range{0xE0000, 0xE0FFF}};

template <std::size_t N>
bool isIn(const std::array<Range, N>& ranges, char32_t character) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const Range& range) { return character >= range.first && character <= range.last; });
}

}  // namespace

std::string plainText(std::string_view text, std::size_t longest) {
  if (text.size() <= longest + kCut.size() && text.ends_with(kCut)) longest += kCut.size();  // It was cut before.
  std::string plain;
  for (std::size_t at = 0; at < text.size();) {
    const auto [character, length] = characterAt(text, at);
    std::string_view piece = text.substr(at, length);
    if (character == kNoCharacter || isIn(kHidden, character))
      piece = kUnknown;
    else if (isIn(kBlanks, character))
      piece = " ";
    if (plain.size() + piece.size() > longest) return plain.append(kCut);
    plain += piece;
    at += length;
  }
  return plain;
}

}  // namespace hapticell
