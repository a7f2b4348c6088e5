// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "trajectory/programs/writing/program_export.h"

namespace hapticell::trajectory {

/// The longest name of a program that the controller accepts, in characters.
std::size_t longestProgramName(ProgramFormat format);

/// True for words that the language reserves (keywords, built-in types, instructions and functions, system modules) and
/// for names that the written program uses for its targets. Case does not matter.
bool isReservedName(std::string_view name, ProgramFormat format);

/// `wanted` (UTF-8) as a name that the language accepts: accented Latin letters lose their accent, all other characters
/// become `_`; it begins with a letter; a reserved word gets the prefix "p_"; FANUC and INFORM names are upper case; a
/// name that is too long is cut. Never empty.
std::string programName(const std::string& wanted, ProgramFormat format);

}  // namespace hapticell::trajectory
