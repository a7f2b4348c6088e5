// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "geometry/system/error.h"

namespace hapticell::workcell {

/// Who has a document open.
struct DocumentOwner {
  std::string user, host, since;  ///< `since`: local time, as "2026-11-26 09:30".
  std::int64_t process = 0;
  std::uint64_t process_start = 0;  ///< In the system's ticks since its start: distinguishes processes with the same
                                    ///< number.

  /// "anna on station2 since 2026-11-26 09:30 (process 4711)"
  Text words() const;
};

/// Marks a document as open in this program, by a hidden file next to it, .NAME.lock, which names the owner and is
/// locked while the owner runs. A file left by a program that ended is ignored; on another machine's disk, where that
/// cannot be known, it counts until it is taken over. Removed with this object. It does not prevent writing: programs
/// must check it.
class DocumentLock {
 public:
  /// No lock.
  DocumentLock() = default;
  /// Locks the document at that path (following a symbolic link), unless another program has it: then owner() says who.
  /// If no file can be made, nobody has it: nobody can save there either. Also removes files that ended programs of
  /// this machine left for other documents of its folder.
  static DocumentLock take(const std::filesystem::path& document);
  /// For writing once. Error: another program has the document open.
  static Expected<DocumentLock> takeForWriting(const std::filesystem::path& document);
  DocumentLock(DocumentLock&& other) noexcept;
  DocumentLock& operator=(DocumentLock&& other) noexcept;
  ~DocumentLock();

  bool isHeld() const { return file_ >= 0; }
  /// The other owner; empty if this program has the lock, or nobody can.
  const std::optional<DocumentOwner>& owner() const { return owner_; }
  /// Tries again, because the other program may have ended. True: no other program has it.
  bool tryAgain();
  /// Like tryAgain(), but also ignores an owner on another machine who may have ended.
  void takeOver();

 private:
  void lock(bool over_other_machines);
  void release();

  std::filesystem::path path_;
  int file_ = -1;
  std::optional<DocumentOwner> owner_;
};

/// Path of the lock file of a document.
std::filesystem::path lockOf(const std::filesystem::path& document);

}  // namespace hapticell::workcell
