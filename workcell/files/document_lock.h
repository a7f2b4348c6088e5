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

/// Says that this program has a document open, by a hidden file next to it, .NAME.lock, which names the owner and is
/// locked while the owner runs. What a dead program left counts for nothing; on another machine's disk, where that
/// is not known, it counts until it is taken over. Goes with this object. It keeps nobody from writing: programs ask
/// it.
class DocumentLock {
 public:
  /// None.
  DocumentLock() = default;
  /// Of the document at that path (what a symbolic link means), unless another has it: then owner() says who. Where no
  /// file can be made, neither is so: there nobody can save either. What dead programs of this machine left for other
  /// documents of its folder is removed.
  static DocumentLock take(const std::filesystem::path& document);
  /// For what is written in one go. Error: another program has it open.
  static Expected<DocumentLock> takeForWriting(const std::filesystem::path& document);
  DocumentLock(DocumentLock&& other) noexcept;
  DocumentLock& operator=(DocumentLock&& other) noexcept;
  ~DocumentLock();

  bool isHeld() const { return file_ >= 0; }
  /// The other one; none where this program has it, or nobody can.
  const std::optional<DocumentOwner>& owner() const { return owner_; }
  /// Looks again: the other one may be gone. True: nobody else has it.
  bool tryAgain();
  /// As tryAgain(), and an owner on another machine who may be gone counts no longer.
  void takeOver();

 private:
  void lock(bool over_other_machines);
  void release();

  std::filesystem::path path_;
  int file_ = -1;
  std::optional<DocumentOwner> owner_;
};

/// Where the lock of a document is.
std::filesystem::path lockOf(const std::filesystem::path& document);

}  // namespace hapticell::workcell
