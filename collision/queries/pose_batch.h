// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "collision/queries/scene.h"

namespace hapticell::collision {

/// How many poses are measured.
struct PoseBatchOptions {
  double limit = std::numeric_limits<double>::infinity();  ///< m; pairs from here on are not reported.
  bool until_contact = false;                              ///< Poses after the first one in contact are left out.
  int threads = 0;                                         ///< At most so many; 0: one a core.
  /// Once true, no further pose is measured, and the answers are not complete. Null: never.
  const std::atomic<bool>* stop = nullptr;
};

/// Answers of a batch, in the order of the poses.
struct PoseBatch {
  std::vector<std::optional<PairDistance>> nearest;  ///< One a measured pose; empty: nothing nearer than the limit.
  std::vector<double> query_us;                      ///< How long each query took, microseconds.
  double seconds = 0.0;                              ///< Wall time of the whole batch.
};

/// The nearest pair of `scene` with `part` at each of the poses (X_WP), on all cores. Every block of poses begins with a
/// fresh copy of `scene`, so the answers do not depend on the number of threads. Any thread; `scene` is not changed.
PoseBatch nearestAtPoses(const Scene& scene, PartIndex part, std::span<const Pose> poses,
                         const PoseBatchOptions& options = {});

}  // namespace hapticell::collision
