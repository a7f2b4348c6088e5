// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/system/error.h"
#include "workcell/document/document_state.h"

namespace hapticell::workcell {

// What a program keeps of a document that is not saved, against its own end. Each run has its own folder (RunFolder) in
// the user's state folder; it is locked while the run lives, so that copies left by an ended run (findLeftWork()) are
// distinguished from those of another running window.

/// The folder in which the folders of runs are: $XDG_STATE_HOME/hapticell/runs, else below ~/.local/state.
std::filesystem::path runsFolder();

/// The folder of one run. It is made by the first who asks for it and goes with this object, unless it holds a copy.
/// One thread.
class RunFolder {
 public:
  RunFolder() = default;
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  /// Made and locked. Error: no folder can be made there.
  Expected<std::filesystem::path> path();
  /// The document was saved, closed or replaced in an orderly way: removes the copy.
  void discardCopy();
  /// Takes over the copy that another run left: from here on it is this run's.
  Expected<void> adopt(const std::filesystem::path& left);

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

/// What a copy is a copy of: by content, since clocks are set back.
struct CopyFacts {
  std::filesystem::path document;  ///< Where it belongs; empty: a new one.
  std::string base;           ///< contentName() of the document's file when it was read or last saved; empty: unknown.
  std::string as_saved;       ///< contentName() of the file that saving the copy's state would write.
  std::uint64_t counter = 0;  ///< Grows from copy to copy, over all runs whose folders are there.
};

/// Writes the copy of a state that belongs to the document at `document` (empty: a new one), whose file held `base`
/// (contentName()) when it was read or last saved, into a run's folder. The old copy stays complete until the new one
/// is. Any thread, one at a time.
Expected<void> autosave(const DocumentState& state, const std::filesystem::path& document,
                        const std::filesystem::path& run, const std::string& base = {});

/// Of the copy in a run's folder. Nothing of use where none says it.
CopyFacts copyFactsIn(const std::filesystem::path& run);

/// Where autosave() writes to.
std::filesystem::path copyIn(const std::filesystem::path& run);
/// Path of a picture of the copy, if the program made one (JPEG).
std::filesystem::path pictureIn(const std::filesystem::path& run);
/// Where the program notes what broke, as one line of text.
std::filesystem::path crashNoteIn(const std::filesystem::path& run);

/// A document as it was when its run ended without saving it.
struct LeftWork {
  std::filesystem::path run;
  std::filesystem::path copy;      ///< Opened by loadDocument(). Empty: nothing was unsaved, it only broke.
  std::filesystem::path document;  ///< Where it belongs; empty: a new one.
  bool document_changed = false;   ///< Its file was written by others since the work began: the copy lacks that.
  std::uint64_t counter = 0;       ///< Greater: the later copy, whatever the clocks say.
  std::filesystem::path picture;   ///< Empty: none.
  std::string crash;               ///< What broke, as one line; empty: it was ended from outside.
  std::filesystem::file_time_type time{};  ///< Of the copy, or of the note.
};

/// Recovery copies left by earlier runs, newest first. A copy equal to the document's file is not listed but removed,
/// because nothing is lost.
std::vector<LeftWork> findLeftWork();

/// It was restored and saved, or is not wanted.
void discardLeftWork(const std::filesystem::path& run);

}  // namespace hapticell::workcell
