// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hapticell {

/// Default limit of a foreign text, bytes: three lines of a message. Half: paths are cut; twice: messages fill the
/// panel.
inline constexpr std::size_t kLongestText = 300;

/// Makes foreign text (from the network, a file, a driver) safe to log, print or draw: one line of valid UTF-8 without
/// invisible characters. Control characters (C0, DEL, C1, line and paragraph separators) become blanks; invisible
/// characters, characters that change the reading direction (bidirectional marks, zero-width signs, tags) and bytes
/// that are not UTF-8 become U+FFFD. Text longer than `longest` bytes is cut between characters and ends in "...".
/// Applying it twice gives the same text.
std::string plainText(std::string_view text, std::size_t longest = kLongestText);

}  // namespace hapticell
