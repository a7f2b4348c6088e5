// SPDX-License-Identifier: Apache-2.0
#include "workcell/autosave.h"

#include <algorithm>
#include <cstdlib>
#include <string>

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

constexpr int kMostKept = 9;

fs::path keptPath(const fs::path& path, int number) {
  return autosavePath(path).string() + "-kept" + std::to_string(number);
}

/// A copy that holds what the document does not.
bool isNewer(const fs::path& copy, const fs::path& path) {
  std::error_code fault;
  if (!fs::is_regular_file(copy, fault)) return false;
  if (path.empty() || !fs::exists(path, fault)) return true;
  const auto saved = fs::last_write_time(path, fault), copied = fs::last_write_time(copy, fault);
  return !fault && copied >= saved;
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
  return isNewer(copy, path) ? std::optional(copy) : std::nullopt;
}

std::vector<fs::path> keepAutosaves(const fs::path& path) {
  std::error_code fault;
  if (const auto copy = findAutosave(path)) {
    for (int number = 1; number <= kMostKept; ++number) {
      const fs::path kept = keptPath(path, number);
      if (fs::exists(kept, fault) && (number < kMostKept || isNewer(kept, path))) continue;
      fs::rename(*copy, kept, fault);
      break;
    }
  }
  std::vector<fs::path> found;
  for (int number = 1; number <= kMostKept; ++number) {
    if (const fs::path kept = keptPath(path, number); isNewer(kept, path)) found.push_back(kept);
  }
  std::stable_sort(found.begin(), found.end(), [&](const fs::path& a, const fs::path& b) {
    return fs::last_write_time(a, fault) > fs::last_write_time(b, fault);
  });
  return found;
}

void discardAutosave(const fs::path& path) {
  std::error_code ignored;
  fs::remove(autosavePath(path), ignored);
}

}  // namespace hapticell::workcell
