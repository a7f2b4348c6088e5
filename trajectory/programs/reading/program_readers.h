// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "trajectory/programs/reading/program_reader.h"

namespace hapticell::trajectory {

/// The text of a program's files. Errors and notes of the readers name lines; the caller adds the file.
struct ProgramText {
  std::string source;
  std::string data;       ///< KRL: the .dat beside it.
  std::string more_data;  ///< KRL: a $config.dat in the same folder.
};

Expected<ReadProgram> readKrl(const ProgramText& text, const ProgramReadOptions& options);
Expected<ReadProgram> readRapid(const std::string& text, const ProgramReadOptions& options);
Expected<ReadProgram> readFanuc(const std::string& text, const ProgramReadOptions& options);
Expected<ReadProgram> readUrScript(const std::string& text, const ProgramReadOptions& options);
Expected<ReadProgram> readInform(const std::string& text, const ProgramReadOptions& options);
/// Reads the program `start` of a VAL3 application as this program writes it, to measure it: its database and code.
Expected<ReadProgram> readVal3(const std::string& data, const std::string& code);

}  // namespace hapticell::trajectory
