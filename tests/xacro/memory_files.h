// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "xacro/expand.h"

namespace hapticell::xacro::test {

/// Expands texts that stand in memory: no file is touched.
class MemoryFiles {
 public:
  std::map<std::string, std::string> texts;  ///< By "/folder/name".
  Arguments arguments;
  Diagnostics diagnostics;
  std::vector<DeclaredArgument> declared;

  Expected<Expanded> expandFile(const std::string& name) {
    declared.clear();
    Files files;
    files.read = [this](const std::filesystem::path& path) -> Expected<std::string> {
      const auto found = texts.find(path.string());
      if (found == texts.end()) return makeError({.file = path.string(), .found = "the file does not exist"});
      return found->second;
    };
    files.find = [this](const std::string& reference, const std::filesystem::path& folder) {
      const bool package = reference.starts_with("package://");
      const auto path = package ? "/" + reference.substr(10) : (folder / reference).lexically_normal().string();
      return texts.count(path) ? std::optional<std::filesystem::path>(path) : std::nullopt;
    };
    return expand(name, arguments, files, declared, diagnostics);
  }

  /// What stands inside of <a> when `inside` stood there: tags without line ends; or the error's message.
  std::string expanded(const std::string& inside) {
    texts["/a.xacro"] = "<a xmlns:xacro=\"http://www.ros.org/wiki/xacro\">" + inside + "</a>";
    const auto result = expandFile("/a.xacro");
    if (!result) return result.error().message();
    std::string text = result->text;
    std::erase(text, '\n');
    if (text == "<a/>") return "";
    return text.substr(3, text.size() - 7);
  }
  /// What ${expression} gives.
  std::string value(const std::string& expression) {
    const std::string text = expanded("<v v=\"${" + expression + "}\"/>");
    return text.starts_with("<v v=\"") ? text.substr(6, text.size() - 9) : text;
  }
};

}  // namespace hapticell::xacro::test
