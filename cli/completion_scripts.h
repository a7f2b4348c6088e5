// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace hapticell::cli {

/// What makes bash, zsh or fish ask `hapticell-cli completion words` for completions; the other programs' options are
/// taken from their --help. Empty for other shells.
std::string_view completionScript(std::string_view shell);

}  // namespace hapticell::cli
