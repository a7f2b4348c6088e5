// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <set>

namespace hapticell::workcell {

/// The files that readers of this thread read whole while it lives: what a robot includes, in whatever format. One at a
/// time (an inner one hides the outer). Files that the importer's process reads are not among them.
class ReadRecord {
 public:
  ReadRecord();
  ~ReadRecord();
  ReadRecord(const ReadRecord&) = delete;
  ReadRecord& operator=(const ReadRecord&) = delete;

  /// Absolute.
  const std::set<std::filesystem::path>& files() const { return files_; }
  /// Called by readers; does nothing where no record lives.
  static void note(const std::filesystem::path& file);

 private:
  std::set<std::filesystem::path> files_;
  ReadRecord* outer_;
};

}  // namespace hapticell::workcell
