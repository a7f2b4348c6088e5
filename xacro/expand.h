// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::xacro {

/// How the reader reaches files: it opens none by itself.
struct Files {
  /// The text of a file. Error: it is not there, is no regular file, is too large.
  std::function<Expected<std::string>(const std::filesystem::path&)> read;
  /// The file that "package://NAME/rest", a path, or a path relative to `folder` stands for; nothing: there is none.
  std::function<std::optional<std::filesystem::path>(const std::string& reference, const std::filesystem::path& folder)>
      find;
};

/// Values of <xacro:arg> by name, as after xacro's NAME:=VALUE.
using Arguments = std::map<std::string, std::string>;

/// An argument that a file asks for.
struct DeclaredArgument {
  std::string name;
  std::string value;                     ///< What was given, else the default.
  std::optional<std::string> otherwise;  ///< The default; nothing where there is none: a value must be given.
  std::string file;
  int line = 0;

  bool operator==(const DeclaredArgument&) const = default;
};

/// A plain description, an element a line, and where each line comes from.
struct Expanded {
  struct Place {
    std::string file;
    int line = 0;
  };
  std::string text;
  std::vector<Place> places;                 ///< Of line 1, 2 … of the text.
  std::vector<std::filesystem::path> files;  ///< All that was read, the first in front.
};

/// Expands a xacro file: properties, macros, blocks, conditions, includes, arguments and expressions, as the program
/// xacro of ROS does (docs/user/formats.md lists what). "$(find NAME)" becomes "package://NAME".
///
/// The file runs no code: see interpreter.h. Everything is bounded (budget.h), so that any file ends within a second.
/// `declared` gets the arguments that were met, also where the file is refused. What cannot be evaluated inside of
/// <gazebo>, <transmission> or <ros2_control>, which move nothing, is left out with a warning. Errors name file, line,
/// and the macros on the way: a name that is not defined, an unknown macro, parameter or substitution, a file that is
/// not there, what is passed over a bound. Any thread.
Expected<Expanded> expand(const std::filesystem::path& file, const Arguments& arguments, const Files& files,
                          std::vector<DeclaredArgument>& declared, Diagnostics& diagnostics);

}  // namespace hapticell::xacro
