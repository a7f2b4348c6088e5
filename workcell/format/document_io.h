// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document.h"
#include "workcell/scenes/import_monitor.h"

namespace hapticell::workcell {

/// An entity that was kept although its file could not be read.
struct UnloadedEntity {
  std::string name;
  Error cause;
  Text remark;  ///< The sentence in the diagnostics.
};

/// How to read a document with missing files.
struct LoadOptions {
  /// Asked where a missing file is now, once per file, but not for a file in a folder that an earlier answer moved.
  /// Empty answers leave it missing.
  std::function<std::optional<std::filesystem::path>(const std::filesystem::path& missing)> locate = {};
  /// If an entity's file is missing or broken, the entity is kept as in the document (Entity::unloaded) and reported,
  /// and the reading continues.
  bool keep_unloaded = false;
  /// Receives those entities; may be null.
  std::vector<UnloadedEntity>* unloaded = nullptr;
  /// A state whose shapes may be used instead of reading them again, where the text says that they come of the same
  /// source: for a text that was made from it a moment ago. Null: everything is read.
  const DocumentState* known = nullptr;
  /// Gets the progress of reading and decides whether to continue; may be null.
  ImportMonitor* monitor = nullptr;
};

/// Reads a workcell document (*.hcell, docs/user/formats.md) with the meshes and robots that it names. On error there
/// is no document; the message names file and entity. Error also for a version newer than ours. Reports unknown but
/// harmless items (a key, a name in a pair set) in `diagnostics`. The document is not dirty and knows its path.
Expected<Document> loadDocument(const std::filesystem::path& path, Diagnostics& diagnostics,
                                const LoadOptions& options = {});

/// The same from text; files are relative to `folder`, messages use `name`.
Expected<Document> parseDocument(std::string_view text, const std::filesystem::path& folder, const std::string& name,
                                 Diagnostics& diagnostics, const LoadOptions& options = {});

/// The text of a state for a file in `folder` (absolute): the same state gives the same bytes, and reading them gives
/// the same state.
std::string documentText(const DocumentState& state, const std::filesystem::path& folder);

/// Writes the document as a temporary file and moves it to `path`, so that a failure leaves the old file. First copies
/// recordings from elsewhere next to it (gatherRecordings()). On success the document is no longer dirty and has this
/// path.
Expected<void> saveDocument(Document& document, const std::filesystem::path& path);

/// "stop", "slide", "pass" and "constant", "contact", "dynamics".
const char* wordOf(OnContact on_contact);
const char* wordOf(ForceClass force_class);

}  // namespace hapticell::workcell
