// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "trajectory/program_writers.h"
#include "trajectory/robot_angles.h"
#include "trajectory/trajectory_io.h"

namespace hapticell::trajectory {

namespace {

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

/// Adds numbered lines of the program's body.
class Body {
 public:
  void add(const std::string& statement) { text_ += padded(std::to_string(++count_), 4) + ":" + statement + " ;\n"; }
  const std::string& text() const { return text_; }
  std::size_t count() const { return count_; }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

std::string positionOf(const ProgramInput& input, std::size_t i) {
  const Pose& X = input.trajectory[i].X_WT;
  const dvec3 p = kMillimetres * X.p;
  const dvec3 wpr = fanucAngles(X.q);
  std::string configuration = input.configurationAt(i);
  if (configuration.empty()) configuration = "N U T, 0, 0, 0";
  const auto field = [](const char* name, double value, const char* unit, int decimals) {
    return "\t" + std::string(name) + " = " + padded(fixedText(value, decimals), 10) + "  " + unit;
  };
  return "P[" + std::to_string(i + 1) + "]{\n   GP1:\n\tUF : 0, UT : 1,\t\tCONFIG : '" + configuration + "',\n" +
         field("X", p.x, "mm", 4) + "," + field("Y", p.y, "mm", 4) + "," + field("Z", p.z, "mm", 4) + ",\n" +
         field("W", wpr.x, "deg", 5) + "," + field("P", wpr.y, "deg", 5) + "," + field("R", wpr.z, "deg", 5) + "\n};\n";
}

/// CNT 100 rounds as far as the next half way; less in proportion to the blend wanted.
std::string termination(const ProgramInput& input, std::size_t i) {
  if (input.blends[i] <= 0.0) return "FINE";
  const double before = glm::length(input.trajectory[i].X_WT.p - input.trajectory[i - 1].X_WT.p);
  const double share = before > 0.0 ? 200.0 * input.blends[i] / before : 0.0;
  return "CNT" + fixedText(std::clamp(share, 1.0, 100.0), 0);
}

}  // namespace

std::vector<ProgramFile> writeFanuc(const ProgramInput& input) {
  Body body;
  body.add("!Made by HaptiCell");
  body.add("!Your own: tool, base, safety");
  body.add("!Before running: check UTOOL,");
  body.add("!UFRAME and start; run slowly");
  const std::string speed = fixedText(std::clamp(kMillimetres * input.options.speed, 1.0, 4000.0), 0) + "mm/sec";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    std::string line = (i == 0 ? "J P[" : "L P[") + std::to_string(i + 1) + "] ";
    line += i == 0 ? fixedText(std::max(1.0, 100.0 * input.options.joint_speed), 0) + "% FINE" : speed;
    if (i > 0) line += ' ' + termination(input, i);
    body.add(line);
    if (input.trajectory[i].dwell > 0.0) body.add("  WAIT   " + fixedText(input.trajectory[i].dwell, 2) + "(sec)");
  }
  std::string text =
      "/PROG  " + input.name + "\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"HaptiCell\";\nPROTECT\t\t= READ_WRITE;\n";
  text += "DEFAULT_GROUP\t= 1,*,*,*,*;\nCONTROL_CODE\t= 00000000 00000000;\n/MN\n" + body.text() + "/POS\n";
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) text += positionOf(input, i);
  text += "/END\n";
  return {{input.name + ".LS", std::move(text)}};
}

}  // namespace hapticell::trajectory
