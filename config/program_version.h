// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hapticell::config {

/// A library that a program runs with, and its version.
struct LibraryVersion {
  std::string name, version;
};

/// What `--version` of a program prints: the program with its version, the commit and the compiler that it was made
/// from and with, and these libraries; a line each, none after the last.
std::string versionText(std::string_view program, const std::vector<LibraryVersion>& libraries);

/// The commit that this was built from, in 12 digits; "unknown" where the sources were no repository.
std::string_view builtCommit();

}  // namespace hapticell::config
