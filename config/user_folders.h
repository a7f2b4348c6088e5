// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::config {

// Where a user's own files are, and which other files are trusted. Nothing is ever searched relative to the current
// folder, because that may belong to a stranger. Any thread, as long as the environment does not change.

/// $XDG_CONFIG_HOME/hapticell, else $HOME/.config/hapticell: settings, keys, device files. Error: neither variable is
/// an absolute path. As the XDG Base Directory Specification has it, a relative $XDG_... counts as not set. No folder
/// is made or opened.
Expected<std::filesystem::path> userSettingsFolder();
/// $XDG_STATE_HOME/hapticell, else $HOME/.local/state/hapticell: copies, fault files.
Expected<std::filesystem::path> userStateFolder();
/// $HOME/.local/lib/hapticell: the user's own plug-ins.
Expected<std::filesystem::path> userLibraryFolder();

/// Checks that only this user (and root) can have written the file or folder: it and the `levels` folders above it
/// belong to this user or root, and no others may write there (a group may where it is its owner's own, with no other
/// members). Missing ones are ignored. Error: the path, its owner, and how to fix it.
Expected<void> checkOwn(const std::filesystem::path& file, int levels);

/// checkOwn() of a file up to the user's folder that it is in: $HOME or $XDG_..., that one included; elsewhere up to
/// the folder that it is in.
Expected<void> checkUserFile(const std::filesystem::path& file);

/// The same for a plug-in: it may also belong to whoever this program's own file belongs to.
Expected<void> checkPlugIn(const std::filesystem::path& file);

/// Makes a folder for this user only (0700), and those above it. Error: it cannot be made, or checkUserFile() of it.
Expected<void> makeOwnFolder(const std::filesystem::path& folder);

/// The absolute paths of a list with ':' between, such as $PATH; others, which would mean the current folder, are left
/// out and, if `refused` is given, added to it.
std::vector<std::filesystem::path> absoluteEntries(const char* list, std::vector<std::string>* refused = nullptr);

/// A program of the system by its name, such as "ffmpeg": the first one in absoluteEntries($PATH) that is executable
/// and that only this user or root can have put there. Empty: not found.
std::filesystem::path systemProgram(const std::string& name);

/// Removes all paths that are not absolute from $PATH and from the variables by which libraries find plug-ins. Call it
/// first in main(), before there are threads; programs started later are then never found in the current folder. It
/// also removes plug-in folders that others may write to, and returns a sentence for each of these.
std::vector<Text> cleanEnvironment();

}  // namespace hapticell::config
