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
  std::filesystem::path document = {};   ///< The packed document; empty if nothing was written.
  std::vector<std::string> copied = {};  ///< Files, relative to the folder.
  std::uintmax_t bytes = 0;
  /// Files outside the document's folder. If PackScope does not allow them, nothing was written and the user must be
  /// asked, because a document from a stranger may name any file of this machine.
  std::vector<std::filesystem::path> outside = {};
  bool isWritten() const { return !document.empty(); }
};

/// Like packDocument(), into a folder or, by its name (isArchiveName()), into an archive, which is read back byte by
/// byte; `document` is then its name in the archive. Replaces an existing archive.
Expected<PackReport> pack(const DocumentState& state, const std::filesystem::path& output, const std::string& name,
                          const PackScope& scope, Diagnostics& diagnostics, ImportMonitor* monitor = nullptr);

/// Writes a pack to `folder` (which must not exist, or be empty): the document as `name` and, in "files", all files
/// that it names and that planPack() accepts: mesh and CAD files with those that they name, robots with the files read
/// for them. Built-in parts need no file; entities whose file could not be read (unloaded) are packed without it and
/// reported. Files of the same name get a number. Reads the pack with all its files back and compares it with the state
/// (checkPack()); `monitor` (may be null) gets the progress. On any error or difference, removes it again.
Expected<PackReport> packDocument(const DocumentState& state, const std::filesystem::path& folder,
                                  const std::string& name, const PackScope& scope, Diagnostics& diagnostics,
                                  ImportMonitor* monitor = nullptr);

}  // namespace hapticell::workcell
