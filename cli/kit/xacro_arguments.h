// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::cli {

/// "FILE,NAME:=VALUE,…": a xacro on the command line with values for its arguments. A file with that whole name has
/// priority.
struct FileWithArguments {
  std::string file;
  std::map<std::string, std::string> arguments;
};
FileWithArguments splitXacroArguments(const std::string& text);

/// Parses words "NAME:=VALUE"; an error names an invalid one.
Expected<std::map<std::string, std::string>> parseXacroArguments(const std::vector<std::string>& words);

}  // namespace hapticell::cli
