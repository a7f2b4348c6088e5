// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hapticell::trajectory {

/// What the text of a robot's language looks like.
struct Dialect {
  bool ignores_case = true;
  char comment = ';';
  bool has_line_ends = true;      ///< A statement ends with its line (else with ';').
  bool has_equals_test = true;    ///< "==" compares and "=" assigns; else "=" compares and ":=" assigns.
  bool has_braces_index = false;  ///< a{1} instead of a[1].
  bool has_poses = false;         ///< p[...] is a pose.
  std::size_t first_index = 1;
};

/// A word, number, text or sign of a program.
struct Token {
  enum class Kind { kWord, kNumber, kText, kSign, kLineEnd };
  Kind kind = Kind::kLineEnd;
  std::string text;  ///< Words in lower case where the language ignores it; texts without their quotes.
  double number = 0.0;
  std::size_t line = 0;  ///< From 1.

  bool is(std::string_view sign_or_word) const {
    return (kind == Kind::kSign || kind == Kind::kWord) && text == sign_or_word;
  }
  bool isWord() const { return kind == Kind::kWord; }
};

using Tokens = std::vector<Token>;

/// The tokens of a program; never fails: a sign that is no part of the language comes as a sign. Lines that begin with
/// '&' (KRL) are left out. A comment "HaptiCell pose ..." is kept as the sign "@pose" and its tokens: it gives the pose
/// that belongs to a move by joints, as this program's own exports write it.
Tokens tokensOf(std::string_view text, const Dialect& dialect);

}  // namespace hapticell::trajectory
