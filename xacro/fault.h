// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

namespace hapticell::xacro {

/// What ends an expansion. Thrown inside of this folder only: expand() turns it into an Error.
struct Fault {
  std::string found, expected, fix;  ///< As in Error.
  std::string file = {};             ///< Set where it is known: by the expander, at the element that it works on.
  int line = 0;

  explicit Fault(std::string what, std::string instead = {}, std::string remedy = {})
      : found(std::move(what)), expected(std::move(instead)), fix(std::move(remedy)) {}
};

}  // namespace hapticell::xacro
