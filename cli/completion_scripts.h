// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace hapticell::cli {

/// The script by which bash, zsh or fish asks `hapticell-cli completion words` for completions; options of the other
/// programs are taken from their --help. Empty for other shells.
std::string_view completionScript(std::string_view shell);

}  // namespace hapticell::cli
