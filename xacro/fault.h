// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::xacro {

/// What ends an expansion. Thrown inside of this folder only: expand() turns it into an Error.
struct Fault {
  Text found{}, expected{}, fix{};  ///< As in Error.
  std::string file{};               ///< Set where it is known: by the expander, at the element that it works on.
  Text place{};                     ///< The line in it; empty if it is not known.
  bool names_expression = false;    ///< `found` says in which expression it is.
  bool names_macro = false;         ///< `found` says in which call of a macro it is.
};

/// "line 3"; empty for a line that is not known.
inline Text linePlace(int line) {
  return line > 0 ? Text("line %1", line) : Text();
}

}  // namespace hapticell::xacro
