// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// A secret that the user types: asked for on the terminal with the echo off, or, where standard input is no terminal,
/// its first line. So it stands in no list of processes and in no shell's history. Error: the input ends, or the line
/// is longer than any code.
Expected<std::string> readTypedCode(const std::string& prompt);

}  // namespace hapticell::cli
