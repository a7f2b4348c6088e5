// SPDX-License-Identifier: Apache-2.0
#include "trajectory/motion/number_text.h"
#include "trajectory/programs/writing/program_writers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

std::string position(const Pose& X) {
  const dvec3 p = kMillimetres * X.p;
  const dvec3 abc = kukaAngles(X.q);
  return "X " + fixedText(p.x, 4) + ",Y " + fixedText(p.y, 4) + ",Z " + fixedText(p.z, 4) + ",A " +
         fixedText(abc.x, 5) + ",B " + fixedText(abc.y, 5) + ",C " + fixedText(abc.z, 5);
}

std::string axes(std::span<const double> joints) {
  std::string text;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    text += (i == 0 ? "A" : ",A") + std::to_string(i + 1) + " " + fixedText(joints[i] * kDegreesPerRadian, 5);
  }
  return text;
}

std::string header(const ProgramInput& input) {
  std::string text = "&ACCESS RVP\nDEF " + input.name + "( )\n";
  text +=
      "; Made by HaptiCell. mm and degrees.\n"
      "; Tool, base and safety (limits, areas, supervision) are your own: check them and the start, run in T1.\n";
  text += "; The user's own: $TOOL" + (input.options.tool.empty() ? "" : " = " + input.options.tool) + ", $BASE" +
          (input.options.base.empty() ? "" : " = " + input.options.base) + "\n";
  text += "BAS (#INITMOV,0)\n";
  if (!input.options.tool.empty()) text += "$TOOL = " + input.options.tool + "\n";
  if (!input.options.base.empty()) text += "$BASE = " + input.options.base + "\n";
  text += "$VEL.CP = " + input.speed() + "\n";
  text += "$ACC.CP = " + input.acceleration() + "\n";
  for (int axis = 1; axis <= 6; ++axis) {
    text += "$VEL_AXIS[" + std::to_string(axis) + "] = " + input.jointSpeed() + "\n";
  }
  return text;
}

std::string target(std::size_t i) {
  return "XP" + std::to_string(i + 1);
}

}  // namespace

/// Points stand in the data file, moves in the source file. The first move names axes, or status and turn.
std::vector<ProgramFile> writeKrl(const ProgramInput& input) {
  std::string source = header(input);
  std::string data = "&ACCESS RVP\nDEFDAT " + input.name + "\n";
  double blend = -1.0;
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    const auto& frame = input.trajectory[i];
    const std::string configuration = input.configurationAt(i);
    data += "DECL E6POS " + target(i) + "={" + position(frame.X_WT) +
            (configuration.empty() ? "" : "," + configuration) + ",E1 0.0,E2 0.0,E3 0.0,E4 0.0,E5 0.0,E6 0.0}\n";
    if (i == 0) {
      // The comment gives readers the pose that belongs to the axes.
      source += "PTP " + (input.hasJoints() ? '{' + axes(input.trajectory.joints(0)) + "} ; HaptiCell pose " : std::string()) +
                target(0) + "\n";
    } else {
      if (input.blends[i] > 0.0 && input.blends[i] != blend) {
        blend = input.blends[i];
        source += "$APO.CDIS = " + input.blend(i) + "\n";
      }
      source += "LIN " + target(i) + (input.blends[i] > 0.0 ? " C_DIS" : "") + "\n";
    }
    if (frame.dwell > 0.0) source += "WAIT SEC " + input.dwell(i) + "\n";
  }
  return {{input.name + ".src", source + "END\n"}, {input.name + ".dat", data + "ENDDAT\n"}};
}

}  // namespace hapticell::trajectory
