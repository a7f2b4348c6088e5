// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "xacro/value.h"

namespace hapticell::xacro {

/// Checks the number of arguments of a call: `least` to `most` values, and named ones only if `named` is true.
inline void expectArguments(const Call& call, const std::string& name, std::size_t least, std::size_t most,
                            bool named = false) {
  if (call.arguments.size() >= least && call.arguments.size() <= most && (named || call.named.empty())) return;
  throw Fault{.found = Text("%1() with %2 arguments", name, call.arguments.size() + call.named.size()),
              .expected = least == most ? Text(std::to_string(least)) : Text("%1 to %2", least, most)};
}

/// The text that was given; Fault for another kind.
inline const std::string& textArgument(const Call& call, const std::string& name, std::size_t index) {
  const std::string* text = call.arguments[index].text();
  if (!text) throw Fault{.found = Text("%1() with %2", name, kindOf(call.arguments[index])), .expected = "a text"};
  return *text;
}

}  // namespace hapticell::xacro
