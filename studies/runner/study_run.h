// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>

#include "studies/runner/study.h"
#include "studies/store/result_store.h"

namespace hapticell::studies {

/// How far a run is. Units are variants, or searches.
struct RunProgress {
  std::size_t done = 0, total = 0;  ///< Units of this run; those that were there before are not counted.
  double seconds = 0.0;             ///< Since it began.
};

struct RunOptions {
  std::size_t chunk = 1, chunks = 1;  ///< 1 <= chunk <= chunks
  int jobs = 0;                       ///< Threads; 0: one a core.
  std::function<void(const RunProgress&)> progress = {};  ///< Called from any thread, one at a time; may be empty.
  /// New rows once they are in the store, in the order of their numbers. Called from any thread, one at a time.
  std::function<void(const std::vector<ResultRow>&)> rows = {};
  const std::atomic<bool>* cancelled = nullptr;           ///< Ends the run after the variants that are being evaluated.
};

struct RunSummary {
  std::int64_t rows = 0;        ///< That this run made.
  std::int64_t kept_units = 0;  ///< That were complete before.
  bool complete = false;        ///< All units of the chunk are in the store.
  double seconds = 0.0;
};

/// Runs the units of a chunk that the store does not have yet, on `jobs` threads, and writes them as they come. The rows
/// do not depend on chunks, jobs, interruptions and machines of the same kind of processor. Errors: those of the store
/// (a full disk); the rows written before stay.
Expected<RunSummary> runStudy(const Study& study, ResultStore& store, const RunOptions& options);

}  // namespace hapticell::studies
