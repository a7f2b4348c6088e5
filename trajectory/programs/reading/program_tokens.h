// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hapticell::trajectory {

/// The syntax of a robot language's text.
struct Dialect {
  bool ignores_case = true;
  char comment = ';';
  bool has_line_ends = true;      ///< A statement ends at the end of the line (otherwise with ';').
  bool has_equals_test = true;    ///< "==" compares and "=" assigns; else "=" compares and ":=" assigns.
  bool has_braces_index = false;  ///< a{1} instead of a[1].
  bool has_poses = false;         ///< p[...] is a pose.
  std::size_t first_index = 1;
};

/// A word, number, text or sign of a program.
struct Token {
  enum class Kind { kWord, kNumber, kText, kSign, kLineEnd };
  Kind kind = Kind::kLineEnd;
  std::string text;  ///< Words in lower case if the language ignores case; texts without quotes.
  double number = 0.0;
  std::size_t line = 0;  ///< From 1.

  bool is(std::string_view sign_or_word) const {
    return (kind == Kind::kSign || kind == Kind::kWord) && text == sign_or_word;
  }
  bool isWord() const { return kind == Kind::kWord; }
};

using Tokens = std::vector<Token>;

/// The tokens of a program; never fails: an unknown character becomes a sign token. Lines that begin with '&' (KRL) are
/// skipped. A comment "HaptiCell pose ..." is kept as the sign "@pose" with its tokens: it gives the pose that belongs
/// to a joint move, as this program's own exports write it.
Tokens tokensOf(std::string_view text, const Dialect& dialect);

}  // namespace hapticell::trajectory
