// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/motions/kept_motion.h"

#include <cmath>

#include "geometry/system/scratch_folder.h"
#include "trajectory/files/trajectory_io.h"
#include "workcell/text/file_content.h"

namespace hapticell::app {

std::optional<Promise> missedPromise(const trajectory::Trajectory& made, const MeasureMotion& measure) {
  // What cannot be measured is not kept.
  const Promise unknown{"measuring", 0.0, std::nan("")};
  const auto folder = ScratchFolder::make();
  if (!folder) return unknown;
  const std::filesystem::path file = folder->path() / "motion.htraj";
  if (!workcell::writeFileAtomically(file, trajectory::toJsonText(made), {.durable = false})) return unknown;
  const auto promises = measure(file);
  if (!promises) return unknown;
  const Promise* worst = promises->worst();
  return worst == nullptr ? std::nullopt : std::optional<Promise>(*worst);
}

}  // namespace hapticell::app
