// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hapticell::cli {

/// One of HaptiCell's other programs by its name: beside this one, else where the system has it. Empty: it is not
/// there.
std::filesystem::path siblingProgram(const std::string& name);

/// What a program printed on standard output before it ended; it is ended after `patience` ms. Empty: it could not be
/// started or printed nothing. Its other output is dropped.
std::string answerOf(const std::filesystem::path& program, const std::vector<std::string>& arguments, int patience);

}  // namespace hapticell::cli
