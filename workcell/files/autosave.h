// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

// What a program keeps of an unsaved document in case it ends unexpectedly. Each run has its own folder (RunFolder) in
// the user's state folder. The folder is locked while the run lives, so that copies left by an ended run
// (findLeftWork()) are distinguished from those of another running window.

/// The parent folder of the runs' folders: $XDG_STATE_HOME/hapticell/runs, else below ~/.local/state.
std::filesystem::path runsFolder();

/// The folder of one run. The first call of path() makes it; it is removed with this object, unless it contains a copy.
/// One thread.
class RunFolder {
 public:
  RunFolder() = default;
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  /// Makes and locks it if necessary. Error: the folder cannot be made.
  Expected<std::filesystem::path> path();
  /// Removes the copy, because the document was saved, closed or replaced properly.
  void discardCopy();
  /// Takes over the copy that another run left: from now on it belongs to this run.
  Expected<void> adopt(const std::filesystem::path& left);

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

/// What a recovery copy is a copy of; compared by content, because clocks may be set back.
struct CopyFacts {
  std::filesystem::path document;  ///< Its document's path; empty: a new one.
  std::string base;           ///< contentName() of the document's file when it was read or last saved; empty: unknown.
  std::string as_saved;       ///< contentName() of the file that saving the copy's state would write.
  std::uint64_t counter = 0;  ///< Increases from copy to copy, over all runs whose folders exist.
};

/// Writes the copy of a state of the document at `document` (empty: a new one) into a run's folder; the document's file
/// held `base` (contentName()) when it was read or last saved. The old copy stays complete until the new one is
/// complete. Any thread, one at a time.
Expected<void> autosave(const DocumentState& state, const std::filesystem::path& document,
                        const std::filesystem::path& run, const std::string& base = {});

/// Facts about the copy in a run's folder. Empty if they are missing.
CopyFacts copyFactsIn(const std::filesystem::path& run);

/// The file that autosave() writes.
std::filesystem::path copyIn(const std::filesystem::path& run);
/// Path of a picture of the copy, if the program made one (JPEG).
std::filesystem::path pictureIn(const std::filesystem::path& run);
/// The file in which the program notes the cause of a crash, as one line of text.
std::filesystem::path crashNoteIn(const std::filesystem::path& run);

/// A document at the time when its run ended without saving it.
struct LeftWork {
  std::filesystem::path run;
  std::filesystem::path copy;      ///< For loadDocument(). Empty: nothing was unsaved, the program only crashed.
  std::filesystem::path document;  ///< Its document's path; empty: a new one.
  bool document_changed = false;   ///< Others wrote its file since the work began: the copy lacks these changes.
  std::uint64_t counter = 0;       ///< Greater means later, whatever the clocks say.
  std::filesystem::path picture;   ///< Empty: none.
  std::string crash;               ///< Cause of the crash, as one line; empty: it was ended from outside.
  std::filesystem::file_time_type time{};  ///< Time of the copy, or of the note.
};

/// Recovery copies left by earlier runs, newest first. A copy equal to the document's file is not listed but removed,
/// because nothing is lost.
std::vector<LeftWork> findLeftWork();

/// Removes unsaved work that was restored and saved, or is not wanted.
void discardLeftWork(const std::filesystem::path& run);

}  // namespace hapticell::workcell
