// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "workcell/document/command.h"

namespace hapticell::app {

/// A command as Python that does the same to `cell` (a hapticell.Workcell): one line or more, each ending with a line
/// break. `before` is the state before the command. A command that the package has no method for becomes a comment that
/// says so. Any thread.
std::string pythonCall(const workcell::Command& command, const workcell::DocumentState& before);

/// The text as a literal of Python.
std::string pythonText(const std::string& text);

}  // namespace hapticell::app
