// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>

namespace hapticell::workcell {

/// The files that readers of this thread read while it exists: what a robot includes, in any format. One at a time (an
/// inner one hides the outer one). Does not list files that the importer's process reads.
class ReadRecord {
 public:
  ReadRecord();
  ~ReadRecord();
  ReadRecord(const ReadRecord&) = delete;
  ReadRecord& operator=(const ReadRecord&) = delete;

  /// Absolute paths.
  const std::set<std::filesystem::path>& files() const { return files_; }
  /// Called by readers; does nothing if no record exists.
  static void note(const std::filesystem::path& file);

 private:
  std::set<std::filesystem::path> files_;
  ReadRecord* outer_;
};

}  // namespace hapticell::workcell
