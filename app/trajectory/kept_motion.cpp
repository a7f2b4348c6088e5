// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory/kept_motion.h"

#include <QTemporaryDir>
#include <cmath>

#include "trajectory/trajectory_io.h"
#include "workcell/file_content.h"

namespace hapticell::app {

std::optional<Promise> missedPromise(const trajectory::Trajectory& made, const MeasureMotion& measure) {
  // What cannot be measured is not kept.
  const Promise unknown{"measuring", 0.0, std::nan("")};
  const QTemporaryDir folder;
  if (!folder.isValid()) return unknown;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "motion.htraj";
  if (!workcell::writeFileAtomically(file, trajectory::toJsonText(made))) return unknown;
  const auto promises = measure(file);
  if (!promises) return unknown;
  const Promise* worst = promises->worst();
  return worst == nullptr ? std::nullopt : std::optional<Promise>(*worst);
}

}  // namespace hapticell::app
