// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "geometry/system/error.h"
#include "haptic/server/fault_recorder.h"

namespace hapticell::haptic {

/// Writes fault-TICK.csv, a row a tick, into the folder (made if it is not there); gives its path. Never by the force
/// thread. Errors: it cannot be written, or others may write to the folder.
Expected<std::filesystem::path> writeFault(const FaultRecord& record, const std::filesystem::path& folder);

/// How much of a disk faults may take.
struct FaultBudget {
  std::size_t files = 20;                           ///< In the folder, of all runs; the oldest are removed.
  std::uintmax_t bytes = std::uintmax_t{16} << 20;  ///< Of those.
  std::size_t at_once = 5;                          ///< Written as they come, of one run: the first tell most.
  double pause = 60.0;                              ///< s between two files after those.
};

/// The fault files of a run, held to a budget: a client can make faults as often as it likes. One thread.
class FaultFiles {
 public:
  /// `folder`: where, or why there is none.
  explicit FaultFiles(Expected<std::filesystem::path> folder, FaultBudget budget = {});
  /// writeFault(); nothing where the budget does not allow one now. `now_ns`: any steady clock.
  Expected<std::optional<std::filesystem::path>> write(const FaultRecord& record, std::int64_t now_ns);
  std::uint64_t leftOut() const { return left_out_; }  ///< Faults without a file.

 private:
  void removeOldest(const std::filesystem::path& newest) const;

  Expected<std::filesystem::path> folder_;
  FaultBudget budget_;
  std::size_t written_ = 0;
  std::uint64_t left_out_ = 0;
  std::int64_t written_ns_ = 0;
};

}  // namespace hapticell::haptic
