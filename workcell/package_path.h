// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hapticell::workcell {

/// Finds the file that a robot description names: "package://NAME/rest" or "model://NAME/rest", "file://path", an
/// absolute path, or one relative to the description's folder.
///
/// A package is looked for beside the description and in each folder above it: a folder called NAME, or one whose
/// package.xml says so; then in the folders of ROS_PACKAGE_PATH and, under share/, of AMENT_PREFIX_PATH. Empty when
/// there is no such file, and for a package's file that is outside of it (leavesPackage()).
///
/// Links inside a package are followed within it, and out of it only to a file of the same name: workspaces of ROS 2
/// consist of such links, while "part.stl" that leads to somebody's "id_rsa" is no part of a package.
std::optional<std::filesystem::path> resolveMeshPath(const std::string& uri,
                                                     const std::filesystem::path& description_folder);

/// True for a "package://" or "model://" whose ".." lead out of the package: no package needs it, and a description
/// from a stranger might have other files looked at.
bool leavesPackage(const std::string& uri);

}  // namespace hapticell::workcell
