// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/system/error.h"
#include "geometry/system/promise.h"
#include "trajectory/motion/trajectory.h"
#include "trajectory/programs/writing/program_export.h"

namespace hapticell::trajectory_checks {

/// Every target of a robot program is within kProgramPromise of its frame. `read`: the content of the written files, as
/// read from them. Errors: the reader of the language does not understand something, or the targets differ.
Expected<Promises> programPromises(const trajectory::Trajectory& given,
                                   const std::vector<trajectory::ProgramFile>& read, trajectory::ProgramFormat format,
                                   const trajectory::ProgramOptions& options);

}  // namespace hapticell::trajectory_checks
