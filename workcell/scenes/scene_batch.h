// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "workcell/scenes/import_scene.h"

namespace hapticell::workcell {

/// The CAD and scene files (holdsScene()) that one robot or cell names. One run of the importer's process reads them
/// all, because starting it for each one would cost more than reading most meshes. One thread.
class SceneBatch {
 public:
  /// `monitor` (may be null) gets the progress of all reading here and can cancel it; it must outlive this object.
  explicit SceneBatch(ImportOptions options, ImportMonitor* monitor = nullptr) : options_(options), monitor_(monitor) {}

  const ImportOptions& options() const { return options_; }
  bool isCancelled() const { return monitor_ && monitor_->isCancelled(); }

  /// Reads those of `files` that hold a scene, each once. If the process fails on one of them, nothing is kept and
  /// scene() reads each one separately, so that only the faulty one is missing. Limits are those of one import.
  void readAhead(const std::vector<std::filesystem::path>& files);

  /// Like readScene() with the options: from what was read ahead, else read now. Keeps each file's error.
  Expected<ImportedScene> scene(const std::filesystem::path& file) const;

 private:
  ImportOptions options_;
  ImportMonitor* monitor_;
  std::map<std::string, Expected<ImportedScene>> known_;
};

/// Output of the importer's process for several files: for each, in their order, the bytes of a scene or an error as
/// packed() writes it.
struct BatchEntry {
  bool is_scene = false;
  std::string content;
};
std::string batchBytes(const std::vector<BatchEntry>& entries);
/// Exactly `count` entries, or an error: the bytes cannot be trusted, because the process may have failed.
Expected<std::vector<BatchEntry>> batchFromBytes(std::string_view bytes, std::size_t count);

}  // namespace hapticell::workcell
