// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/system/atomic_file.h"
#include "geometry/system/error.h"
#include "trajectory/motion/trajectory.h"

namespace hapticell::exchange {

struct DemonstrationOptions {
  double rate_hz = 50.0;  ///< Frames per second, 1 to 1000; LeRobot asks for a fixed rate.
  std::string task;       ///< What was done, in words; empty: the motion's name.
  std::string robot;      ///< The robot's name; empty: the motion's entity.
};

/// Motions as a data set in the layout that LeRobot documents for its version 2.1, an episode each: `meta/info.json`,
/// `meta/tasks.jsonl`, `meta/episodes.jsonl`, `meta/episodes_stats.jsonl`, and `data/chunk-000/episode_000000.csv` in
/// place of Parquet files, which no library of Debian 12 writes. A vector feature has a column for each number, named
/// "observation.state.NAME"; docs/user/recordings-mcap.md has the lines of Python that make Parquet files of them.
///
/// `observation.state` are the joints (the pose for a motion without joints), `action` those of the next frame,
/// `observation.force` and `observation.contact` what was recorded. Numbers between frames are as Trajectory::poseAt()
/// and jointsAt(); forces as at the frame before. Paths are relative to the folder of the data set. Errors: a rate out
/// of range, no motion or one without frames, motions of different joints.
Expected<std::vector<FileToWrite>> demonstrationFiles(const std::vector<trajectory::Trajectory>& motions,
                                                      const DemonstrationOptions& options);

}  // namespace hapticell::exchange
