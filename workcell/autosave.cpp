// SPDX-License-Identifier: Apache-2.0
#include "workcell/autosave.h"

#include <cstdlib>

#include "workcell/document_io.h"
#include "workcell/file_content.h"

namespace hapticell::workcell {

namespace fs = std::filesystem;

namespace {

fs::path stateFolder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state) return fs::path(state) / "hapticell";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".local/state/hapticell";
  return fs::temp_directory_path() / "hapticell";
}

}  // namespace

fs::path autosavePath(const fs::path& path) {
  if (path.empty()) return stateFolder() / "untitled.hcell.autosave";
  return path.parent_path() / ("." + path.filename().string() + ".autosave");
}

Expected<void> autosave(const Document& document) {
  return document.isDirty() ? autosave(document.state(), document.path()) : Expected<void>();
}

Expected<void> autosave(const DocumentState& state, const fs::path& path) {
  const fs::path file = fs::absolute(autosavePath(path));
  std::error_code fault;
  fs::create_directories(file.parent_path(), fault);
  return writeFileAtomically(file, documentText(state, file.parent_path()));
}

std::optional<fs::path> findAutosave(const fs::path& path) {
  const fs::path copy = autosavePath(path);
  std::error_code fault;
  if (!fs::is_regular_file(copy, fault)) return std::nullopt;
  if (path.empty() || !fs::exists(path, fault)) return copy;
  const auto saved = fs::last_write_time(path, fault), copied = fs::last_write_time(copy, fault);
  return !fault && copied >= saved ? std::optional(copy) : std::nullopt;
}

void discardAutosave(const fs::path& path) {
  std::error_code ignored;
  fs::remove(autosavePath(path), ignored);
}

}  // namespace hapticell::workcell
