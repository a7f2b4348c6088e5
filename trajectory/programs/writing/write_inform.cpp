// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdio>

#include "trajectory/programs/writing/program_writers.h"
#include "trajectory/programs/reading/robot_angles.h"

namespace hapticell::trajectory {

namespace {

constexpr const char* kLine = "\r\n";

std::string variable(std::size_t i) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "C%05zu", i);
  return text.data();
}

/// The positions' head: frame, tool and form.
std::string positionHead(const ProgramInput& input) {
  const std::string& base = input.options.base;
  std::string text =
      "//POS" + std::string(kLine) + "///NPOS " + std::to_string(input.trajectory.size()) + ",0,0,0,0,0" + kLine;
  if (!base.empty()) text += "///USER " + base + kLine;
  text += "///TOOL " + (input.options.tool.empty() ? "0" : input.options.tool) + kLine;
  text += std::string("///POSTYPE ") + (base.empty() ? "BASE" : "USER") + kLine;
  return text + "///RECTAN" + kLine + "///RCONF 1,0,0,0,0,0,0,0" + kLine;
}

std::string instructions(const ProgramInput& input) {
  std::string text = "NOP" + std::string(kLine);
  for (const char* remark :
       {"Made by HaptiCell: mm, deg", "Your own: tool, base, safety", "Check start and configuration"})
    text += "'" + std::string(remark) + kLine;
  const std::string speed = input.speed();
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    text += i == 0 ? "MOVJ " + variable(i) + " VJ=" + input.jointSpeed() : "MOVL " + variable(i) + " V=" + speed;
    // CR: the corner's radius; PL=0: right at the point.
    text += (input.blends[i] > 0.0 ? " CR=" + input.blend(i) : " PL=0") + std::string(kLine);
    if (input.trajectory[i].dwell > 0.0) text += "TIMER T=" + input.dwell(i) + kLine;
  }
  return text + "END" + kLine;
}

}  // namespace

/// A job with positions in its own C variables. The first move goes to a pose too: joints are pulses there, which only
/// the controller knows.
std::vector<ProgramFile> writeInform(const ProgramInput& input) {
  std::string text = "/JOB" + std::string(kLine) + "//NAME " + input.name + kLine + positionHead(input);
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    const dvec3 p = kMillimetres * input.trajectory[i].X_WT.p;
    // Rx, Ry, Rz about the frame's own fixed axes, as FANUC's W, P, R.
    const dvec3 r = fanucAngles(input.trajectory[i].X_WT.q);
    text += variable(i) + "=" + numberList({p.x, p.y, p.z}, 3) + "," + numberList({r.x, r.y, r.z}, 4) + kLine;
  }
  text += "//INST" + std::string(kLine) + "///DATE 2000/01/01 00:00" + kLine + "///ATTR SC,RW,RJ" + kLine;
  text += "////FRAME " + (input.options.base.empty() ? "BASE" : "USER " + input.options.base) + kLine;
  text += "///GROUP1 RB1" + std::string(kLine) + instructions(input);
  return {{input.name + ".JBI", std::move(text)}};
}

}  // namespace hapticell::trajectory
