// SPDX-License-Identifier: Apache-2.0
#include "collision/queries/pose_batch.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace hapticell::collision {

namespace {

/// Poses that one copy of the scene measures one after another: each query starts from the answer before. Half: more
/// cold queries; twice: fewer blocks to share out among many cores.
constexpr std::size_t kBlock = 64;

using Clock = std::chrono::steady_clock;

void lower(std::atomic<std::size_t>& least, std::size_t value) {
  for (std::size_t known = least; value < known && !least.compare_exchange_weak(known, value);) {
  }
}

}  // namespace

PoseBatch nearestAtPoses(const Scene& scene, PartIndex part, std::span<const Pose> poses,
                         const PoseBatchOptions& options) {
  PoseBatch batch;
  batch.nearest.resize(poses.size());
  batch.query_us.resize(poses.size());
  std::atomic<std::size_t> first_contact{poses.size()};
  const auto measure = [&](std::size_t block) {
    Scene own = scene;
    const std::size_t end = std::min(poses.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) {
      if (options.until_contact && i > first_contact) return;
      if (options.stop != nullptr && *options.stop) return;
      const auto begin = Clock::now();
      own.setPose(part, poses[i]);
      batch.nearest[i] = own.nearest(options.limit);
      batch.query_us[i] = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
      if (batch.nearest[i] && batch.nearest[i]->result.colliding) lower(first_contact, i);
    }
  };
  const auto begin = Clock::now();
  const std::size_t blocks = (poses.size() + kBlock - 1) / kBlock;
  tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, blocks, measure); });
  batch.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  if (options.until_contact && first_contact < poses.size()) {
    batch.nearest.resize(first_contact + 1);
    batch.query_us.resize(first_contact + 1);
  }
  return batch;
}

}  // namespace hapticell::collision
