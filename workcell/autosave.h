// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "geometry/error.h"
#include "workcell/document.h"

namespace hapticell::workcell {

// A copy of an unsaved document beside it, so that a crash costs a minute and not a day. How it is used: autosave() now
// and then; discardAutosave() after saving and at an orderly end; findAutosave() before a document is opened, and where
// it finds one, loadDocument() of that file, setPath() to the document's own and markUnsaved(). A program that goes on
// autosaving while the user decides calls keepAutosaves() first.

/// Where the copy of the document at `path` stands: ".NAME.autosave" in the same folder, so that relative names stay
/// right. A document without a path has it in the user's state folder (XDG_STATE_HOME, else ~/.local/state).
std::filesystem::path autosavePath(const std::filesystem::path& path);

/// Writes the copy where the document has unsaved changes; does nothing else. The document's own path and whether it is
/// dirty stay as they are.
Expected<void> autosave(const Document& document);

/// Writes the copy of a state that belongs to the document at `path` (empty: a new one). Any thread.
Expected<void> autosave(const DocumentState& state, const std::filesystem::path& path);

/// The copy of the document at `path`, where there is one that is newer than the document (or the document is gone).
std::optional<std::filesystem::path> findAutosave(const std::filesystem::path& path);

/// The copies of the document at `path` that are newer than it, newest first, moved aside: autosave() and
/// discardAutosave() leave them alone from then on. Each stays, and is found again, until its file is removed.
std::vector<std::filesystem::path> keepAutosaves(const std::filesystem::path& path);

/// Removes the copy that autosave() writes; it is no error when there is none.
void discardAutosave(const std::filesystem::path& path);

}  // namespace hapticell::workcell
