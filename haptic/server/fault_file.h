// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "geometry/system/error.h"
#include "haptic/server/fault_recorder.h"

namespace hapticell::haptic {

/// Writes fault-TICK.csv, one row per tick, into the folder (made if missing); returns its path. Not for the force
/// thread. Errors: it cannot be written, or others may write to the folder.
Expected<std::filesystem::path> writeFault(const FaultRecord& record, const std::filesystem::path& folder);

/// Limits of the disk space for fault files.
struct FaultBudget {
  std::size_t files = 20;                           ///< Files in the folder, of all runs; the oldest are removed.
  std::uintmax_t bytes = std::uintmax_t{16} << 20;  ///< Total size of these files.
  std::size_t at_once = 5;                          ///< Faults of one run that are written at once; the first ones are
                                                    ///< the most useful.
  double pause = 60.0;                              ///< s between two later files.
};

/// Writes the fault files of a run within a budget, because a client can cause faults as often as it likes. One thread.
class FaultFiles {
 public:
  /// `folder`: the folder, or why it could not be determined.
  explicit FaultFiles(Expected<std::filesystem::path> folder, FaultBudget budget = {});
  /// writeFault(), or no path if the budget does not allow a file now. `now_ns`: any steady clock.
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
