// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geometry/system/atomic_file.h"
#include "geometry/system/error.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

/// Old to new path of recordings.
using MovedRecordings = std::map<std::string, std::string>;

struct GatheredRecordings {
  MovedRecordings moved;
  std::vector<FileToWrite> files;
};

/// Where recordings of the document at `document` are put: NAME-trajectories beside it.
std::filesystem::path recordingsFolder(const std::filesystem::path& document);

/// Brings the recordings of a state that is to be saved at `document` (absolute) together with it, so that it can be
/// passed on together with the files next to it: those that lie elsewhere than in its folder, or below that, are copied
/// into recordingsFolder(). Those whose file is missing, or is no recording, are left alone. Writes nothing: the files
/// are for saving together with the document.
GatheredRecordings gatherRecordings(const DocumentState& state, const std::filesystem::path& document);

}  // namespace hapticell::workcell
