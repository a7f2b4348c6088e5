// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/writing/program_writers.h"

namespace hapticell::trajectory {

namespace {

constexpr const char* kNoExternalAxes = "[9E9,9E9,9E9,9E9,9E9,9E9]";

std::string robtarget(const ProgramInput& input, std::size_t i) {
  const Pose& X = input.trajectory[i].X_WT;
  const dvec3 p = kMillimetres * X.p;
  // The positive one of the two quaternions of an orientation.
  const dquat q = X.q.w < 0.0 ? -X.q : X.q;
  std::string configuration = input.configurationAt(i);
  if (configuration.empty()) configuration = "[0,0,0,0]";
  return "[[" + numberList({p.x, p.y, p.z}, 4) + "],[" + numberList({q.w, q.x, q.y, q.z}, 9) + "]," + configuration +
         "," + kNoExternalAxes + "]";
}

std::string zone(const ProgramInput& input, std::size_t i) {
  if (input.blends[i] <= 0.0) return "fine";
  // As zonedata: path, orientation (mm) and the defaults of the finer named zones.
  const double mm = kMillimetres * input.blends[i];
  return "[FALSE," + numberList({mm, 1.5 * mm, 1.5 * mm, 0.15 * mm, 1.5 * mm, 0.15 * mm}, 3) + "]";
}

}  // namespace

std::vector<ProgramFile> writeRapid(const ProgramInput& input) {
  const std::string tool = input.options.tool.empty() ? "tool0" : input.options.tool;
  const std::string frame = input.options.base.empty() ? "" : "\\WObj:=" + input.options.base;
  const std::string ending = "," + tool + frame + ";\n";
  std::string text = "MODULE " + input.name + "\n";
  text +=
      "  ! Made by HaptiCell. mm, degrees for joints.\n"
      "  ! Tool, work object (base) and safety (limits, zones) are your own: check them and the start, run slowly.\n";
  text += "  ! The user's own: " + tool + (frame.empty() ? ", wobj0" : ", " + input.options.base) + "\n";
  text += "  CONST speeddata vLine:=[" + input.speed() + ",500.000,5000.000,1000.000];\n";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    text += "  CONST robtarget p" + std::to_string(i + 1) + ":=" + robtarget(input, i) + ";\n";
  }
  text += "  PROC main()\n";
  const bool has_configuration = !input.configurationAt(0).empty();
  if (!has_configuration) text += "    ConfL\\Off;\n    ConfJ\\Off;\n";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    if (i == 0 && input.hasJoints()) {
      text += "    MoveAbsJ [[" + jointList(input.trajectory.joints(0), 6, kDegreesPerRadian) + "]," + kNoExternalAxes +
              "],vLine,fine," + tool + ";  ! HaptiCell pose p1\n";
    } else {
      text += std::string(i == 0 ? "    MoveJ" : "    MoveL") + " p" + std::to_string(i + 1) + ",vLine," +
              zone(input, i) + ending;
    }
    if (input.trajectory[i].dwell > 0.0) text += "    WaitTime " + input.dwell(i) + ";\n";
  }
  text += "  ENDPROC\nENDMODULE\n";
  return {{input.name + ".mod", std::move(text)}};
}

}  // namespace hapticell::trajectory
