// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// Reads a secret that the user types: on the terminal, without echo; or, if standard input is not a terminal, as its
/// first line. So it does not appear in any list of processes or shell history. Error: the input ends, or the line is
/// longer than any code.
Expected<std::string> readTypedCode(const std::string& prompt);

}  // namespace hapticell::cli
