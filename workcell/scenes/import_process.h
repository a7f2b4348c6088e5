// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/scenes/import_monitor.h"
#include "workcell/entity/import_options.h"

namespace hapticell::workcell {

/// The file descriptors of the importer's process: the scene's bytes (both ways), and a pipe for its lines.
constexpr int kSceneDescriptor = 3;
constexpr int kLinesDescriptor = 4;

/// One run of `hapticell-importer`.
struct ImporterCall {
  std::string file;                    ///< Used in messages.
  std::vector<std::string> arguments;  ///< After the program's name and before its limits.
  std::string scene;                   ///< Input at kSceneDescriptor, for exports.
  ImportLimits limits;
  double processor_seconds = 1e9;  ///< Sum over all its threads.
  ImportMonitor* monitor = nullptr;  ///< May be null.
};

/// Limits the call by the size of its input (bytes; packed files count tenfold): 1.5 s of processor time plus 20 us per
/// byte, so that a broken file of 10 kB fails within two seconds and one of 30 MB has ten minutes; 1.5 GB of memory
/// plus a kilobyte per byte. Never more than call.limits. `finer`: the user asked for more triangles than usual, so all
/// the time of call.limits is allowed.
void limitBySize(ImporterCall& call, std::uintmax_t bytes, bool finer);

/// Runs the importer and returns its output at kSceneDescriptor. Its lines are "progress SHARE STAGE", "error ERROR"
/// (an error as packed() writes it), "part NUMBER" before a part that may crash it, and "done" at the end; any other
/// line ends it. After a crash at a part it is run again without that part ("--skip NUMBER"), a few times. It is killed
/// when cancelled (within 0.1 s), when its time is up, and when the calling process ends. Blocks; any thread.
Expected<std::string> callImporter(const ImporterCall& call);

}  // namespace hapticell::workcell
