// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hapticell::cli {

/// Path of another program of HaptiCell by its name: next to this one, else where the system has it. Empty: not
/// found.
std::filesystem::path siblingProgram(const std::string& name);

/// What a program prints on standard output; it is killed after `patience` ms. Empty: it could not be started or
/// printed nothing. Its other output is dropped.
std::string answerOf(const std::filesystem::path& program, const std::vector<std::string>& arguments, int patience);

}  // namespace hapticell::cli
