// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <filesystem>

// What AtomicFile and ScratchFolder share: names of what is unfinished, its lock, and the disk. Not for others.
namespace hapticell::unfinished {

/// What mkostemps() and mkdtemp() make a name of. The lock (flock) of its maker tells it from what a dead program left.
inline constexpr const char* kPattern = ".hapticell-XXXXXX";

/// Locks what was just made. False: a tidying program was quicker and has removed it, make another one.
bool take(int file, const std::filesystem::path& name);

/// removeUnfinished(), but not again within ten seconds.
void tidyOnce(const std::filesystem::path& folder);

/// Flushes a folder's names to the disk; 0 or errno. A disk that cannot (EINVAL) is none of the caller's faults.
int flushFolder(const std::filesystem::path& folder);

/// The rights that the user takes from new files.
mode_t userMask();

}  // namespace hapticell::unfinished
