// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>

// Shared by AtomicFile and ScratchFolder only: names and locks of unfinished files, flushing to the disk.
namespace hapticell::unfinished {

/// Name pattern for mkostemps() and mkdtemp(). If the maker still runs, it holds a lock (flock) on the file.
inline constexpr const char* kPattern = ".hapticell-XXXXXX";

/// Locks a new file or folder. False: a program that tidies up has removed it already; make another one.
bool take(int file, const std::filesystem::path& name);

/// Calls removeUnfinished(), at most once in ten seconds.
void tidyOnce(const std::filesystem::path& folder);

/// Flushes a folder's names to the disk; returns 0 or errno. A disk that cannot do this (EINVAL) is not an error.
int flushFolder(const std::filesystem::path& folder);

/// The user's umask: the rights that new files do not get.
mode_t userMask();

}  // namespace hapticell::unfinished
