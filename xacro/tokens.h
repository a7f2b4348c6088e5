// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "xacro/value.h"

namespace hapticell::xacro {

/// A word of an expression.
struct Token {
  enum class Kind { kEnd, kName, kSign, kConstant };
  Kind kind = Kind::kEnd;
  std::string text;  ///< Of names and signs.
  Value value;       ///< Of numbers and texts.
};

/// Splits an expression into tokens, with an end token last. Fault for invalid tokens: a text without its closing
/// quote, a number followed by letters, a character that Python does not have.
std::vector<Token> tokensOf(const std::string& text);

}  // namespace hapticell::xacro
