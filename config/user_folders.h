// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"

namespace hapticell::config {

// Where a user's own files are, and which files of others are believed. Nothing is ever looked for relative to the
// current folder: that may be a stranger's. Any thread, as long as nobody changes the environment.

/// $XDG_CONFIG_HOME/hapticell, else $HOME/.config/hapticell: settings, keys, device files. Error: neither variable is
/// an absolute path. As the XDG Base Directory Specification has it, a relative $XDG_... counts as not set. No folder
/// is made or looked at.
Expected<std::filesystem::path> userSettingsFolder();
/// $XDG_STATE_HOME/hapticell, else $HOME/.local/state/hapticell: copies, fault files.
Expected<std::filesystem::path> userStateFolder();
/// $HOME/.local/lib/hapticell: the user's own plug-ins.
Expected<std::filesystem::path> userLibraryFolder();

/// That nobody but this user (and root) can have written what the file, or folder, holds: it and the `levels` folders
/// above it belong to this user or root, and no others may write there (a group may where it is its owner's own, with
/// no other members). What is not there is passed over. Error: which one, whose it is, and what to do.
Expected<void> checkOwn(const std::filesystem::path& file, int levels);

/// checkOwn() of a file up to the user's folder that it is in: $HOME or $XDG_..., that one included; elsewhere up to
/// the folder that it is in.
Expected<void> checkUserFile(const std::filesystem::path& file);

/// The same for a plug-in: it may also belong to whoever this program's own file belongs to.
Expected<void> checkPlugIn(const std::filesystem::path& file);

/// Makes a folder for this user only (0700), and those above it. Error: it cannot be made, or checkUserFile() of it.
Expected<void> makeOwnFolder(const std::filesystem::path& folder);

/// The absolute paths of a list with ':' between, such as $PATH; others, which would mean the current folder, are left
/// out and, where `refused` is given, told there.
std::vector<std::filesystem::path> absoluteEntries(const char* list, std::vector<std::string>* refused = nullptr);

/// A program of the system by its name, such as "ffmpeg": the first one in absoluteEntries($PATH) that is executable
/// and that only this user or root can have put there. Empty: not found.
std::filesystem::path systemProgram(const std::string& name);

/// Takes out of $PATH and of the variables by which libraries find plug-ins what is no absolute path. Called first
/// thing in main(), before there are threads: whatever starts a program later then finds none in the current folder.
/// Plug-in folders that others may write to go too. A sentence for each of the plug-in folders.
std::vector<std::string> cleanEnvironment();

}  // namespace hapticell::config
