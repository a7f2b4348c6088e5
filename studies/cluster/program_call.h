// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::studies {

/// What a program of the system said and how it ended.
struct ProgramAnswer {
  int status = 0;      ///< Exit status; -1: ended by a signal.
  std::string output;  ///< Standard output and standard error, as they came.
};

/// Runs a program that only this user or root can have put into $PATH, found by its name (config::systemProgram), and
/// waits for its end. Never through a shell. Error: there is no such program, or it cannot be started.
Expected<ProgramAnswer> callProgram(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace hapticell::studies
