// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"
#include "workcell/scenes/import_monitor.h"
#include "workcell/files/pack_plan.h"

namespace hapticell::workcell {

struct PackReport {
  std::filesystem::path document = {};   ///< The packed document; empty where nothing was written.
  std::vector<std::string> copied = {};  ///< Files, relative to the folder.
  std::uintmax_t bytes = 0;
  /// Files that lie outside of the document's folder. Where PackScope does not allow them nothing was written: the user
  /// is to be asked, for a stranger's document may name any file of this machine.
  std::vector<std::filesystem::path> outside = {};
  bool isWritten() const { return !document.empty(); }
};

/// As below, into a folder or, by its name (isArchiveName()), into an archive of it, which is read back byte by byte;
/// `document` is then its name in there. An archive that is there already is replaced.
Expected<PackReport> pack(const DocumentState& state, const std::filesystem::path& output, const std::string& name,
                          const PackScope& scope, Diagnostics& diagnostics, ImportMonitor* monitor = nullptr);

/// Makes `folder` (which must not exist, or be empty) hold the document as `name` and, in "files", all that it names
/// and that planPack() takes: mesh and CAD files with what they name, robots with the files that were read for them.
/// Built-in things need no file; entities whose file could not be read (unloaded) are packed without it and reported.
/// Files of one name get a number. The pack is read back with all its files and compared with the state (checkPack()),
/// with progress to `monitor`, which may be null. On error, also where something differs, the folder is removed again.
Expected<PackReport> packDocument(const DocumentState& state, const std::filesystem::path& folder,
                                  const std::string& name, const PackScope& scope, Diagnostics& diagnostics,
                                  ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
