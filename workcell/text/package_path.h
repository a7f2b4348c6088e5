// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/text.h"

namespace hapticell::workcell {

/// A file that a description names, and how it was found.
struct FoundFile {
  std::filesystem::path path;
  /// The folder that was taken for the package although neither its name nor a package.xml says so; empty: it is the
  /// package itself, or none is named.
  std::filesystem::path taken_for_package;
};

/// Finds the file that a robot description names: "package://NAME/rest" or "model://NAME/rest", "file://path", an
/// absolute path, or one relative to the description's folder; "file://package://NAME/rest", as xacro makes of
/// file://$(find NAME), is the package's. Percent-encoded references (RFC 3986: %20, %C3%A4) and such with the
/// backslashes of Windows are found where the name as it is written is not.
///
/// A package is searched next to the description and in each folder above it: a folder called NAME, or one whose
/// package.xml has that name; then in the folders of ROS_PACKAGE_PATH and, under share/, of AMENT_PREFIX_PATH. Archives
/// and vendors often rename folders. Therefore the search continues in the folders up to five levels above the
/// description that contain the rest of the path, and in folders next to these whose name begins with NAME. At last it
/// leaves out the first folders of the rest, as long as a folder and a file remain. `taken_for_package` is then the
/// folder that was used. Empty if there is no such file, and for a file outside its package (leavesPackage()).
///
/// Links inside a package are followed within it, and out of it only to a file of the same name: workspaces of ROS 2
/// consist of such links, while "part.stl" that leads to somebody's "id_rsa" is no part of a package.
std::optional<FoundFile> findReference(const std::string& uri, const std::filesystem::path& description_folder);

/// By the names alone: both whole, without "..".
bool isBelow(const std::filesystem::path& file, const std::filesystem::path& folder);

/// For reports: that the folder `found.taken_for_package` was taken for the package of `uri`.
Text takenForPackage(const std::string& uri, const FoundFile& found);

/// True for a "package://" or "model://" whose ".." lead out of the package: no package needs it, and a description
/// from a stranger might have other files looked at.
bool leavesPackage(const std::string& uri);

/// `text` with each %XX as the byte that it means (RFC 3986); one without two digits, and a zero byte, stay.
std::string percentDecoded(const std::string& text);

}  // namespace hapticell::workcell
