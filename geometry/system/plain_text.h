// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hapticell {

/// Bytes that one piece of others' text is cut to where nobody says.
inline constexpr std::size_t kLongestText = 300;

/// Text of others (from the network, a foreign file, a driver) as it may be logged, printed or drawn: one line of valid
/// UTF-8 that looks like what it is. Control characters (C0, DEL, C1, line and paragraph separators) become blanks;
/// what cannot be seen or turns the direction of reading (bidirectional marks, zero-width signs, tags) and bytes that
/// are no UTF-8 become U+FFFD. What is longer than `longest` bytes is cut between characters and ends in "...".
/// Applied twice it gives the same.
std::string plainText(std::string_view text, std::size_t longest = kLongestText);

}  // namespace hapticell
