// SPDX-License-Identifier: Apache-2.0
#include "cli/kit/xacro_arguments.h"

#include <filesystem>

namespace hapticell::cli {

FileWithArguments splitXacroArguments(const std::string& text) {
  FileWithArguments result{text, {}};
  std::error_code ignored;
  if (text.find(":=") == std::string::npos || std::filesystem::exists(text, ignored)) return result;
  result.file.clear();
  std::string* last = &result.file;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    const std::size_t sign = part.find(":=");
    if (at > 0 && sign != std::string::npos && sign > 0)
      *(last = &result.arguments[part.substr(0, sign)]) = part.substr(sign + 2);
    else
      *last += (at > 0 ? "," : "") + part;
    at = end + 1;
  }
  return result;
}

Expected<std::map<std::string, std::string>> parseXacroArguments(const std::vector<std::string>& words) {
  std::map<std::string, std::string> arguments;
  for (const std::string& word : words) {
    const std::size_t sign = word.find(":=");
    if (sign == std::string::npos || sign == 0)
      return makeError({.place = "arguments", .found = "'" + word + "'", .expected = "NAME:=VALUE"});
    arguments[word.substr(0, sign)] = word.substr(sign + 2);
  }
  return arguments;
}

}  // namespace hapticell::cli
