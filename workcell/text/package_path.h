// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/text.h"

namespace hapticell::workcell {

/// A file that a robot description names, and how it was found.
struct FoundFile {
  std::filesystem::path path;
  /// The folder that was used as the package although neither its name nor a package.xml matches; empty: it is the
  /// package itself, or no package is named.
  std::filesystem::path taken_for_package;
};

/// Finds the file that a robot description names: "package://NAME/rest" or "model://NAME/rest", "file://path", an
/// absolute path, or one relative to the description's folder; "file://package://NAME/rest", which xacro makes of
/// file://$(find NAME), means the package. If a name is not found as written, it is tried with percent-encoding decoded
/// (RFC 3986: %20, %C3%A4) and with the backslashes of Windows replaced.
///
/// Searches a package next to the description and in each folder above it: a folder with the name NAME, or whose
/// package.xml has that name; then in the folders of ROS_PACKAGE_PATH and, under share/, of AMENT_PREFIX_PATH. Archives
/// and vendors often rename folders, so the search continues in the folders up to five levels above the description
/// that contain the rest of the path, and in folders next to these whose name begins with NAME. Last, it leaves out the
/// first folders of the rest, as long as a folder and a file remain. `taken_for_package` is then the folder that was
/// used. Empty if there is no such file, and for a file outside its package (leavesPackage()).
///
/// Follows links within a package; out of it, only to a file with the same name: workspaces of ROS 2 consist of such
/// links, but a "part.stl" that links to somebody's "id_rsa" is not part of a package.
std::optional<FoundFile> findReference(const std::string& uri, const std::filesystem::path& description_folder);

/// Compares names only: both must be complete, without "..".
bool isBelow(const std::filesystem::path& file, const std::filesystem::path& folder);

/// For reports: says that the folder `found.taken_for_package` was used as the package of `uri`.
Text takenForPackage(const std::string& uri, const FoundFile& found);

/// True for a "package://" or "model://" whose ".." lead out of the package: no package needs that, and a description
/// from a stranger could make other files be read.
bool leavesPackage(const std::string& uri);

/// `text` with each %XX replaced by its byte (RFC 3986); one without two digits, and a zero byte, stay.
std::string percentDecoded(const std::string& text);

}  // namespace hapticell::workcell
