// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/scenes/import_monitor.h"
#include "workcell/entity/import_options.h"

namespace hapticell::workcell {

/// The file descriptors that the importer's process finds: the scene's bytes (both ways), and a pipe for its lines.
constexpr int kSceneDescriptor = 3;
constexpr int kLinesDescriptor = 4;

/// One run of `hapticell-importer`.
struct ImporterCall {
  std::string file;                    ///< Used in messages.
  std::vector<std::string> arguments;  ///< Behind the program's name and before its limits.
  std::string scene;                   ///< What it finds at kSceneDescriptor; for exports.
  ImportLimits limits;
  double processor_seconds = 1e9;  ///< Of all its threads together.
  ImportMonitor* monitor = nullptr;  ///< May be null.
};

/// Limits the call by the size of what it reads (bytes; packed files count tenfold): a second and a half of the
/// processor and 20 us a byte, so that a bent file of 10 kB is refused within two seconds and one of 30 MB has ten
/// minutes; 1.5 GB and a kilobyte for each byte. Never more than call.limits. `finer`: the user asked for more
/// triangles than usual, and they have all the time of call.limits.
void limitBySize(ImporterCall& call, std::uintmax_t bytes, bool finer);

/// Runs the importer and gives what it left at kSceneDescriptor. Its lines are "progress SHARE STAGE", "error ERROR"
/// (an error as packed() makes it), "part NUMBER" before a part that may break it down, and at the end "done"; anything
/// else ends it. Where it breaks down at a part it is run again without it ("--skip NUMBER"), a few times. It is killed
/// when it is cancelled (within 0.1 s), when its time is up, and when the calling process dies. Blocks; any thread.
Expected<std::string> callImporter(const ImporterCall& call);

}  // namespace hapticell::workcell
