// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/writing/program_writers.h"

namespace hapticell::trajectory {

std::vector<ProgramFile> writeUrScript(const ProgramInput& input) {
  const std::string& base = input.options.base;
  const auto poseText = [&base](const Pose& X) {
    const dvec3 r = rotationVector(X.q);
    const std::string pose = "p[" + numberList({X.p.x, X.p.y, X.p.z}, 7) + "," + numberList({r.x, r.y, r.z}, 8) + "]";
    return base.empty() ? pose : "pose_trans(" + base + "," + pose + ")";
  };
  const std::string acceleration = input.acceleration();
  const std::string speed = input.speed();
  std::string text =
      "# Made by HaptiCell. m and rad.\n"
      "# Tool (TCP, payload), base and safety (limits, planes) are your own: check them and the start, run slowly.\n";
  text += "def " + input.name + "():\n";
  text += input.options.tool.empty() ? "  # The user's own: set_tcp(...)\n" : "  set_tcp(" + input.options.tool + ")\n";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    const auto& frame = input.trajectory[i];
    if (i == 0) {
      // Joint acceleration and speed of the first move, rad/s2 and rad/s: a share of what the arms reach.
      text += "  movej(";
      text += input.hasJoints() ? '[' + jointList(input.trajectory.joints(0), 8, 1.0) + ']' : poseText(frame.X_WT);
      text += ",a=1.4,v=" + input.jointSpeed() + ")";
      // The comment gives readers the pose that belongs to the joints.
      text += (input.hasJoints() ? "  # HaptiCell pose " + poseText(frame.X_WT) : std::string()) + "\n";
    } else {
      text += "  movel(" + poseText(frame.X_WT) + ",a=" + acceleration + ",v=" + speed;
      text += (input.blends[i] > 0.0 ? ",r=" + input.blend(i) : std::string()) + ")\n";
    }
    if (frame.dwell > 0.0) text += "  sleep(" + input.dwell(i) + ")\n";
  }
  text += "end\n" + input.name + "()\n";
  return {{input.name + ".script", std::move(text)}};
}

}  // namespace hapticell::trajectory
