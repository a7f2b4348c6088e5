// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The CAD and scene files (holdsScene()) that one robot or cell names: read by one run of the importer's process
/// instead of one each, whose start would cost more than most of the meshes. One thread.
class SceneBatch {
 public:
  /// `monitor` (may be null) gets the progress of all reading here and can end it; it must outlive this.
  explicit SceneBatch(ImportOptions options, ImportMonitor* monitor = nullptr) : options_(options), monitor_(monitor) {}

  const ImportOptions& options() const { return options_; }
  bool isCancelled() const { return monitor_ && monitor_->isCancelled(); }

  /// Reads what of `files` holds a scene, each once. Where the process fails on one of them, nothing is kept and
  /// scene() reads each by itself, so that only the faulty one is missing. Limits are those of one import.
  void readAhead(const std::vector<std::filesystem::path>& files);

  /// As readScene() with the options: from what was read ahead, else now. A file's own error is kept.
  Expected<ImportedScene> scene(const std::filesystem::path& file) const;

 private:
  ImportOptions options_;
  ImportMonitor* monitor_;
  std::map<std::string, Expected<ImportedScene>> known_;
};

/// What the importer's process leaves for several files: for each, in their order, a scene's bytes or an error
/// as packed() makes it.
struct BatchEntry {
  bool is_scene = false;
  std::string content;
};
std::string batchBytes(const std::vector<BatchEntry>& entries);
/// Exactly `count` entries, or an error: the bytes come from a process that may have gone mad.
Expected<std::vector<BatchEntry>> batchFromBytes(std::string_view bytes, std::size_t count);

}  // namespace hapticell::workcell
