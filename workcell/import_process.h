// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/error.h"
#include "workcell/import_monitor.h"
#include "workcell/import_options.h"

namespace hapticell::workcell {

/// The file descriptors that the importer's process finds: the scene's bytes (both ways), and a pipe for its lines.
constexpr int kSceneDescriptor = 3;
constexpr int kLinesDescriptor = 4;

/// One run of `hapticell-importer`.
struct ImporterCall {
  std::string file;                    ///< Stands in the messages.
  std::vector<std::string> arguments;  ///< Behind the program's name and before its limits.
  std::string scene;                   ///< What it finds at kSceneDescriptor; for exports.
  ImportLimits limits;
  ImportMonitor* monitor = nullptr;  ///< May be null.
};

/// Runs the importer and gives what it left at kSceneDescriptor. Its lines are "progress SHARE STAGE",
/// "error PLACE|FOUND|EXPECTED|FIX" (tab between the parts) and at the end "done"; anything else ends it. It is killed
/// when it is cancelled (within 0.1 s), when its time is up, and when the calling process dies. Blocks; any thread.
Expected<std::string> callImporter(const ImporterCall& call);

}  // namespace hapticell::workcell
