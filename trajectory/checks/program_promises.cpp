// SPDX-License-Identifier: Apache-2.0
#include "trajectory/checks/program_promises.h"

#include <string>

namespace hapticell::trajectory_checks {

Expected<Promises> programPromises(const trajectory::Trajectory& given,
                                   const std::vector<trajectory::ProgramFile>& read, trajectory::ProgramFormat format,
                                   const trajectory::ProgramOptions& options) {
  const auto measured = trajectory::measureProgram(read, format, options, given);
  HAPTICELL_TRY(measured);
  const trajectory::PathTolerance& asked = trajectory::kProgramPromise;
  const auto at = [](std::size_t frame) { return Text("at frame %1", frame); };
  Promises promises;
  promises.help = "Move the motion nearer to the robot's base.";
  promises.list.push_back(
      {"position", asked.position, measured->largest.position, "m", at(measured->frame_of_position)});
  promises.list.push_back({"angle", asked.angle, measured->largest.angle, "rad", at(measured->frame_of_angle)});
  return promises;
}

}  // namespace hapticell::trajectory_checks
