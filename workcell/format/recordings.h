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

/// The folder for recordings of the document at `document`: NAME-trajectories next to it.
std::filesystem::path recordingsFolder(const std::filesystem::path& document);

/// Collects the recordings of a state that is to be saved at `document` (absolute), so that the document can be passed
/// on together with the files next to it: copies those outside its folder and below, or in a hidden folder there (a
/// cell in the home folder), into recordingsFolder(). Leaves those alone whose file is missing or is not a recording.
/// Writes nothing: the files are to be written when the document is saved.
GatheredRecordings gatherRecordings(const DocumentState& state, const std::filesystem::path& document);

}  // namespace hapticell::workcell
